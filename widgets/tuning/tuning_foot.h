// What stands below tuned values: undo, redo, which values are felt, save.
#pragma once

#include <QPushButton>
#include <QToolButton>
#include <QWidget>

#include "widgets/tuning/tuning_compare.h"
#include "widgets/tuning/tuning_model.h"
#include "widgets/tuning/tuning_question_box.h"

namespace fyd::widgets {

class TuningFoot : public QWidget {
  Q_OBJECT
 public:
  enum class Rows { one, two };

  /// @param own the owner's own: in one row it takes the room before "Save profile", in two it follows "Redo"
  TuningFoot(TuningModel& model, Rows rows, QWidget* own, QWidget* parent = nullptr);

  [[nodiscard]] TuningCompare* compare() const { return compare_; }
  [[nodiscard]] QPushButton* saveButton() const { return save_; }
  /// The doubt about a change of several values, or by undo, redo, A and B.
  [[nodiscard]] TuningQuestionBox* questionBox() const { return question_; }

 signals:
  void saveAsked();

 private:
  void arrange(Rows rows, QWidget* own);
  void refresh();
  void showQuestion();

  TuningModel& model_;
  QToolButton* undo_ = nullptr;
  QToolButton* redo_ = nullptr;
  TuningCompare* compare_ = nullptr;
  QPushButton* save_ = nullptr;
  TuningQuestionBox* question_ = nullptr;
};

}  // namespace fyd::widgets
