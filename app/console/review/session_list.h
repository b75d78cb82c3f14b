// The sessions of the catalogue, to search, to open and to compare; and any other file, by a dialog, its path or of
// those opened lately.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QToolButton>
#include <vector>

#include "app/console/review/recording_files.h"
#include "app/console/shell/background.h"
#include "core/catalogue/catalogue_types.h"

namespace fyd::console {

class SessionList : public QWidget {
  Q_OBJECT
 public:
  /// @param catalogue word as after --catalogue
  /// @param recent must outlive this
  SessionList(QString catalogue, RecentRecordings& recent, QWidget* parent = nullptr);
  /// Asks the catalogue again.
  void look();
  /// Opens a dialog for a recording's file.
  void chooseFile();
  /// The two that are chosen.
  void compareChosen();
  /// What went wrong with a file, in place.
  void sayProblem(const QString& text);
  /// Emits recoverAsked for the recording at the entered path.
  void recoverPath();
  [[nodiscard]] QLineEdit* filter() const { return filter_; }
  [[nodiscard]] QLineEdit* path() const { return path_; }
  [[nodiscard]] QPushButton* recoverButton() const { return recover_; }
  [[nodiscard]] QPushButton* compareButton() const { return compare_; }
  [[nodiscard]] QToolButton* recentButton() const { return recent_; }
  [[nodiscard]] QTableWidget* table() const { return table_; }
  [[nodiscard]] QString words() const { return words_->text(); }
  [[nodiscard]] bool looking() const { return work_.running(); }

 signals:
  void openAsked(const QString& path);
  void recoverAsked(const QString& path);
  /// @param first the earlier one
  void compareAsked(const QString& first, const QString& second);

 private:
  void build();
  void fill(const std::vector<catalogue::CatalogueEntry>& entries);
  void openPath();
  void choose(int row);
  void chooseAgain(int column);
  /// Rows of the table, from the newest session.
  [[nodiscard]] std::vector<int> chosenRows() const;
  /// Nothing is said over a problem before the operator does something else.
  void say(const QString& text);
  void explain(const catalogue::CatalogueEntry& entry);
  /// The entered path; empty: none, and a text says so.
  [[nodiscard]] QString namedPath();

  QString catalogue_;
  QLineEdit* filter_ = nullptr;
  QTableWidget* table_ = nullptr;
  QLineEdit* path_ = nullptr;
  QPushButton* open_ = nullptr;
  QPushButton* choose_ = nullptr;
  QToolButton* recent_ = nullptr;
  QPushButton* compare_ = nullptr;
  QPushButton* recover_ = nullptr;
  QLabel* words_ = nullptr;
  QString problem_;
  std::vector<catalogue::CatalogueEntry> entries_;
  catalogue::CatalogueEntry chosen_;  ///< kept while rows change; without an id: none
  Background work_;
};

}  // namespace fyd::console
