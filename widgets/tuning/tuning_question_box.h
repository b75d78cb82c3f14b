// What speaks against a change that waits, with the two answers. Not modal: everything else works meanwhile, and another
// change takes the question away.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>

#include "widgets/tuning/tuning_model.h"

namespace fyd::widgets {

class TuningQuestionBox : public QFrame {
  Q_OBJECT
 public:
  /// Hidden until showQuestion.
  explicit TuningQuestionBox(TuningModel& model, QWidget* parent = nullptr);

  void showQuestion(const QString& words);
  /// "Leave as it is" takes the focus, so that Enter leaves.
  void takeFocus() { leave_->setFocus(Qt::OtherFocusReason); }

  [[nodiscard]] QString words() const { return words_->text(); }
  [[nodiscard]] QPushButton* leaveButton() const { return leave_; }
  [[nodiscard]] QPushButton* applyButton() const { return apply_; }

 signals:
  /// By one of its buttons, which had the focus.
  void answered();

 private:
  QLabel* words_ = nullptr;
  QPushButton* leave_ = nullptr;
  QPushButton* apply_ = nullptr;
};

}  // namespace fyd::widgets
