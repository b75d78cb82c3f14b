// Every notice of the session with its time, searchable; the newest below.
#pragma once

#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QTableView>
#include <QWidget>

#include "widgets/status/notice_stack.h"

namespace fyd::widgets {

class LogView : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kMost = 5000;  ///< older lines are dropped

  explicit LogView(QWidget* parent = nullptr);
  /// @param when time of day, or since the session's start
  void add(const QString& when, Severity severity, const QString& text);
  [[nodiscard]] QLineEdit* searchField() const { return search_; }
  [[nodiscard]] int shownLines() const { return filter_->rowCount(); }
  [[nodiscard]] int lines() const { return model_->rowCount(); }

 private:
  QStandardItemModel* model_ = nullptr;
  QSortFilterProxyModel* filter_ = nullptr;
  QLineEdit* search_ = nullptr;
  QTableView* table_ = nullptr;
};

}  // namespace fyd::widgets
