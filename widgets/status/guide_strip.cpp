#include "widgets/status/guide_strip.h"

#include <QVBoxLayout>

#include "widgets/basics/icon.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {

GuideStrip::GuideStrip(const QString& name, QWidget* parent)
    : QFrame(parent),
      step_row_(new QHBoxLayout),
      action_row_(new QHBoxLayout),
      advice_(new QLabel(this)),
      close_(new QToolButton(this)) {
  setProperty("surface", "panel");
  setAccessibleName(name);
  advice_->setWordWrap(true);
  advice_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  close_->setIcon(icon(QStringLiteral("cross")));
  close_->setProperty("flat", true);
  close_->setAccessibleName(tr("Close: %1").arg(name));
  close_->setToolTip(close_->accessibleName());
  auto* words = new QVBoxLayout;
  words->setSpacing(kGrid / 2);
  words->addLayout(step_row_);
  words->addWidget(advice_);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * kGrid, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid);
  layout->addLayout(words, 1);
  layout->addLayout(action_row_);
  layout->addWidget(close_, 0, Qt::AlignTop);
  connect(close_, &QToolButton::clicked, this, &GuideStrip::closeAsked);
}

void GuideStrip::setGuide(const std::vector<Step>& steps, std::size_t current, const QString& advice,
                          const std::vector<Action>& actions) {
  advice_->setText(advice);
  if (steps != steps_ || current != current_) {
    steps_ = steps;
    current_ = current;
    rebuildSteps();
  }
  QStringList ids;
  for (const Action& each : actions) ids << each.id;
  if (ids == action_ids_) return;
  action_ids_ = ids;
  rebuildActions(actions);
}

void GuideStrip::rebuildSteps() {
  delete step_body_;
  step_body_ = new QWidget(this);
  auto* row = new QHBoxLayout(step_body_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2 * kGrid);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    // A tick or the step's number: never the weight of the font alone.
    const QString mark = step.done ? QStringLiteral("✓") : QString::number(i + 1);
    auto* label = new QLabel(mark + QStringLiteral("  ") + step.words, step_body_);
    label->setFont(textFont(TextSize::normal, i == current_));
    if (i != current_) label->setProperty("role", "muted");
    label->setAccessibleName(step.done       ? tr("%1: done").arg(step.words)
                             : i == current_ ? tr("%1: now").arg(step.words)
                                             : step.words);
    row->addWidget(label);
  }
  row->addStretch(1);
  step_row_->addWidget(step_body_);
}

void GuideStrip::rebuildActions(const std::vector<Action>& actions) {
  // One of these buttons may be the caller, and have the focus: the next step's button takes it, not the one that Qt
  // finds next, which may record or arm.
  const bool focused = action_body_ != nullptr && action_body_->isAncestorOf(window()->focusWidget());
  if (action_body_ != nullptr) {
    action_body_->hide();
    for (QPushButton* each : action_body_->findChildren<QPushButton*>()) each->setObjectName({});
    action_body_->deleteLater();
  }
  action_body_ = new QWidget(this);
  auto* row = new QHBoxLayout(action_body_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGrid);
  QWidget* before = nullptr;
  for (const Action& each : actions) {
    auto* button = new QPushButton(each.words, action_body_);
    button->setObjectName(each.id);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, [run = each.run] { run(); });
    row->addWidget(button);
    setTabOrder(before != nullptr ? before : close_->previousInFocusChain(), button);
    before = button;
  }
  if (before != nullptr) setTabOrder(before, close_);
  action_row_->addWidget(action_body_);
  if (!focused) return;
  action_body_->show();
  takeFocus();
}

void GuideStrip::takeFocus() {
  QWidget* first = action_ids_.isEmpty() ? static_cast<QWidget*>(close_) : button(action_ids_.front());
  first->setFocus(Qt::OtherFocusReason);
}

}  // namespace fyd::widgets
