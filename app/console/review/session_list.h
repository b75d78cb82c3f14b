// The sessions of the catalogue, to search and to open; and any other file by its path.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <vector>

#include "app/console/shell/background.h"
#include "core/catalogue/catalogue_types.h"

namespace fyd::console {

class SessionList : public QWidget {
  Q_OBJECT
 public:
  /// @param catalogue word as after --catalogue
  explicit SessionList(QString catalogue, QWidget* parent = nullptr);
  /// Asks the catalogue again.
  void look();
  /// Emits recoverAsked for the recording at the entered path.
  void recoverPath();
  [[nodiscard]] QLineEdit* filter() const { return filter_; }
  [[nodiscard]] QLineEdit* path() const { return path_; }
  [[nodiscard]] QPushButton* recoverButton() const { return recover_; }
  [[nodiscard]] QTableWidget* table() const { return table_; }
  [[nodiscard]] QString words() const { return words_->text(); }
  [[nodiscard]] bool looking() const { return work_.running(); }

 signals:
  void openAsked(const QString& path);
  void recoverAsked(const QString& path);

 private:
  void build();
  void fill(const std::vector<catalogue::CatalogueEntry>& entries);
  void openPath();
  void choose(int row);
  void chooseAgain(int column);
  void explain(const catalogue::CatalogueEntry& entry);
  /// The entered path; empty: none, and a text says so.
  [[nodiscard]] QString namedPath();

  QString catalogue_;
  QLineEdit* filter_;
  QTableWidget* table_;
  QLineEdit* path_;
  QPushButton* open_;
  QPushButton* recover_;
  QLabel* words_;
  std::vector<catalogue::CatalogueEntry> entries_;
  catalogue::CatalogueEntry chosen_;  ///< kept while rows change; without an id: none
  Background work_;
};

}  // namespace fyd::console
