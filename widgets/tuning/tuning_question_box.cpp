#include "widgets/tuning/tuning_question_box.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/basics/theme.h"

namespace fyd::widgets {

TuningQuestionBox::TuningQuestionBox(TuningModel& model, QWidget* parent)
    : QFrame(parent),
      words_(new QLabel(this)),
      leave_(new QPushButton(tr("Leave as it is"), this)),
      apply_(new QPushButton(tr("Apply anyway"), this)) {
  setAccessibleName(tr("Not applied yet"));
  words_->setWordWrap(true);
  words_->setProperty("role", "warning");
  leave_->setObjectName(QStringLiteral("question_leave"));
  apply_->setObjectName(QStringLiteral("question_apply"));
  leave_->setToolTip(tr("Keep the value that is in use (Enter)"));
  apply_->setToolTip(tr("Use the new value all the same; undo takes it back"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid);
  buttons->addWidget(leave_);
  buttons->addWidget(apply_);
  buttons->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, kGrid / 2, 0, kGrid / 2);
  layout->setSpacing(kGrid / 2);
  layout->addWidget(words_);
  layout->addLayout(buttons);
  for (QPushButton* button : {leave_, apply_}) button->setAutoDefault(true);  // Enter presses the one in focus
  const auto answer = [this, &model](bool apply) {
    emit answered();  // before the box hides, so that the focus goes where its owner wants it
    apply ? model.applyAnyway() : model.leaveAsItIs();
  };
  connect(leave_, &QPushButton::clicked, this, [answer] { answer(false); });
  connect(apply_, &QPushButton::clicked, this, [answer] { answer(true); });
  hide();
}

void TuningQuestionBox::showQuestion(const QString& words) {
  words_->setText(words + QLatin1Char(' ') + tr("Not applied yet."));
  setAccessibleDescription(words_->text());
  show();
}

}  // namespace fyd::widgets
