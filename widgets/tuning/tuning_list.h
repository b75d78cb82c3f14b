// Every live parameter, grouped by what it is about, with a search: for tuning beyond the favourites.
#pragma once

#include <QCheckBox>
#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <vector>

#include "widgets/tuning/tuning_model.h"
#include "widgets/tuning/tuning_row.h"

class QVBoxLayout;

namespace fyd::widgets {

class TuningList : public QFrame {
  Q_OBJECT
 public:
  explicit TuningList(TuningModel& model, QWidget* parent = nullptr);

  [[nodiscard]] QLineEdit* search() const { return search_; }
  [[nodiscard]] QCheckBox* onlyChanged() const { return only_changed_; }
  [[nodiscard]] const std::vector<TuningRow*>& rows() const { return rows_; }
  [[nodiscard]] TuningRow* row(const QString& id) const;
  [[nodiscard]] QString summary() const { return summary_->text(); }
  /// How many rows the search leaves.
  [[nodiscard]] int shownCount() const;

 signals:
  void refused(const QString& why, const QString& parameter);
  void entered();  ///< Enter ended an entry: the focus is free to go

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Group {
    QLabel* title;
    std::vector<TuningRow*> rows;
  };

  void addRows(QVBoxLayout* layout);
  void filter();
  /// The first row that the search leaves gets the focus.
  void goToFirst();

  TuningModel& model_;
  QLineEdit* search_ = nullptr;
  QCheckBox* only_changed_ = nullptr;
  QLabel* summary_ = nullptr;
  QLabel* empty_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  std::vector<Group> groups_;
  std::vector<TuningRow*> rows_;
};

}  // namespace fyd::widgets
