// The sessions of the catalogue, to search and to open; and any other file by its path.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <vector>

#include "app/console/background.h"
#include "core/session/catalogue_types.h"

namespace fyd::console {

class SessionList : public QWidget {
  Q_OBJECT
 public:
  /// @param catalogue word as after --catalogue
  explicit SessionList(QString catalogue, QWidget* parent = nullptr);
  /// Asks the catalogue again.
  void look();
  /// Asks for the recovery of the recording whose path is named.
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
  void fill(const std::vector<session::CatalogueEntry>& entries);
  void openPath();
  void choose(int row);
  void chooseAgain(int column);
  void explain(const session::CatalogueEntry& entry);
  /// Empty: none, which is said.
  [[nodiscard]] QString namedPath();

  QString catalogue_;
  QLineEdit* filter_;
  QTableWidget* table_;
  QLineEdit* path_;
  QPushButton* open_;
  QPushButton* recover_;
  QLabel* words_;
  std::vector<session::CatalogueEntry> entries_;
  session::CatalogueEntry chosen_;  ///< rows come and go; without an id: none
  Background work_;
};

}  // namespace fyd::console
