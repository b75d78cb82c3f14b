// A/B comparison: applies the saved values (A) or the current ones (B). While A is on, nothing can be changed.
#pragma once

#include <QToolButton>
#include <QWidget>

#include "widgets/tuning/tuning_model.h"

namespace fyd::widgets {

class TuningCompare : public QWidget {
  Q_OBJECT
 public:
  explicit TuningCompare(TuningModel& model, QWidget* parent = nullptr);
  [[nodiscard]] QToolButton* savedButton() const { return saved_; }
  [[nodiscard]] QToolButton* currentButton() const { return current_; }

 private:
  void refresh();

  TuningModel& model_;
  QToolButton* saved_ = nullptr;
  QToolButton* current_ = nullptr;
};

}  // namespace fyd::widgets
