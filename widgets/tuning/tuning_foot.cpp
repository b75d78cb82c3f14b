#include "widgets/tuning/tuning_foot.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/basics/icon.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {

TuningFoot::TuningFoot(TuningModel& model, Rows rows, QWidget* own, QWidget* parent)
    : QWidget(parent),
      model_(model),
      undo_(new QToolButton(this)),
      redo_(new QToolButton(this)),
      compare_(new TuningCompare(model, this)),
      save_(new QPushButton(this)),
      question_(new TuningQuestionBox(model, this)) {
  undo_->setObjectName(QStringLiteral("undo_button"));
  undo_->setIcon(icon(QStringLiteral("undo")));
  undo_->setAccessibleName(tr("Undo"));
  redo_->setObjectName(QStringLiteral("redo_button"));
  redo_->setIcon(icon(QStringLiteral("redo")));
  redo_->setAccessibleName(tr("Redo"));
  save_->setObjectName(QStringLiteral("save_button"));
  save_->setIcon(icon(QStringLiteral("save")));
  save_->setAutoDefault(false);
  arrange(rows, own);
  connect(undo_, &QToolButton::clicked, &model_, &TuningModel::undo);
  connect(redo_, &QToolButton::clicked, &model_, &TuningModel::redo);
  connect(save_, &QPushButton::clicked, this, &TuningFoot::saveAsked);
  connect(&model_, &TuningModel::changed, this, &TuningFoot::refresh);
  connect(&model_, &TuningModel::feelingSavedChanged, this, &TuningFoot::refresh);
  connect(&model_, &TuningModel::questionChanged, this, &TuningFoot::showQuestion);
  connect(model_.undoStack(), &QUndoStack::indexChanged, this, &TuningFoot::refresh);
  refresh();
}

void TuningFoot::arrange(Rows rows, QWidget* own) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGrid, kGrid / 2, kGrid, kGrid);
  layout->setSpacing(kGrid / 2);
  layout->addWidget(question_);
  auto* first = new QHBoxLayout;
  first->setSpacing(kGrid / 2);
  first->addWidget(undo_);
  first->addWidget(redo_);
  layout->addLayout(first);
  if (rows == Rows::one) {
    first->addSpacing(kGrid);
    first->addWidget(compare_);
    first->addSpacing(kGrid);
    first->addWidget(own, 1);
    first->addWidget(save_);
    return;
  }
  first->addWidget(own);
  first->addStretch(1);
  first->addWidget(compare_);
  layout->addWidget(save_, 0, Qt::AlignRight);
}

void TuningFoot::showQuestion() {
  const auto& question = model_.question();
  if (question && question->id.isEmpty()) {
    question_->showQuestion(question->words);
  } else {
    question_->hide();
  }
}

void TuningFoot::refresh() {
  const QUndoStack* stack = model_.undoStack();
  const bool saved = model_.feelingSaved();  // undo and redo then only return to the current values
  undo_->setEnabled(stack->canUndo() || saved);
  redo_->setEnabled(stack->canRedo() || saved);
  undo_->setToolTip(stack->canUndo() ? tr("Undo %1 (Ctrl+Z)").arg(stack->undoText()) : tr("Nothing to undo"));
  redo_->setToolTip(stack->canRedo() ? tr("Redo %1 (Ctrl+Shift+Z)").arg(stack->redoText()) : tr("Nothing to redo"));
  save_->setText(model_.anyChanged() ? tr("• Save profile") : tr("Save profile"));
  save_->setToolTip(model_.anyChanged() ? tr("Marked values differ from the profile (Ctrl+S)")
                                        : tr("Nothing differs from the profile (Ctrl+S)"));
}

}  // namespace fyd::widgets
