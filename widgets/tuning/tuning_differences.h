// What differs from the saved profile: saved beside current, and the ways back.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>

#include "widgets/tuning/tuning_model.h"

namespace fyd::widgets {

class TuningDifferences : public QWidget {
  Q_OBJECT
 public:
  explicit TuningDifferences(TuningModel& model, QWidget* parent = nullptr);
  [[nodiscard]] QTableWidget* table() const { return table_; }
  [[nodiscard]] QPushButton* revertButton() const { return revert_; }
  [[nodiscard]] QPushButton* revertAllButton() const { return revert_all_; }
  [[nodiscard]] QString words() const { return words_->text(); }

 signals:
  void refused(const QString& why);

 private:
  void refresh();

  TuningModel& model_;
  QLabel* words_ = nullptr;
  QTableWidget* table_ = nullptr;
  QPushButton* revert_ = nullptr;
  QPushButton* revert_all_ = nullptr;
};

}  // namespace fyd::widgets
