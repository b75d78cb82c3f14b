#include "widgets/status/readiness_list.h"

#include <QGridLayout>
#include <QToolButton>

#include "widgets/basics/icon.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {

ReadinessList::ReadinessList(QWidget* parent)
    : QFrame(parent), title_(new QLabel(this)), layout_(new QVBoxLayout(this)) {
  setProperty("surface", "panel");
  setAccessibleName(tr("Readiness"));
  title_->setFont(textFont(TextSize::normal, true));
  layout_->setContentsMargins(2 * kGrid, kGrid, kGrid, kGrid);
  layout_->setSpacing(kGrid / 2);
  layout_->addWidget(title_);
  connect(&Look::instance(), &Look::changed, this, &ReadinessList::rebuild);
  rebuild();
}

void ReadinessList::setRows(const std::vector<ReadinessRow>& rows) {
  if (rows == rows_) return;
  rows_ = rows;
  rebuild();
}

void ReadinessList::rebuild() {
  const auto ready = std::count_if(rows_.begin(), rows_.end(), [](const ReadinessRow& row) { return row.ok; });
  title_->setText(rows_.empty() ? tr("Ready? Waiting for the station")
                                : tr("Ready? %1/%2").arg(ready).arg(static_cast<qsizetype>(rows_.size())));
  QWidget* former = body_;
  body_ = new QWidget(this);
  auto* grid = new QGridLayout(body_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(kGrid);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  int line = 0;
  for (const ReadinessRow& row : rows_) {
    auto* mark = new QLabel(body_);
    mark->setPixmap(
        icon(row.ok ? QStringLiteral("check") : QStringLiteral("warning"), row.ok ? theme().live : theme().warning)
            .pixmap(QSize(16, 16), devicePixelRatioF()));
    auto* what = new QLabel(row.what, body_);
    what->setFont(textFont(TextSize::small, !row.ok));
    what->setWordWrap(true);
    what->setAccessibleName(row.what +
                            (row.ok ? tr(": yes") : tr(": no. ") + row.why + QLatin1String(". ") + row.remedy));
    grid->addWidget(mark, line, 0, Qt::AlignTop);
    grid->addWidget(what, line++, 1);
    if (!row.ok) addTrouble(*grid, row, line);
  }
  layout_->addWidget(body_);
  setAccessibleDescription(title_->text());
  if (former != nullptr) retire(*former);
  placeInTabOrder();
}

void ReadinessList::retire(QWidget& former) {
  const QWidget* focus = window()->focusWidget();
  if (focus != nullptr && former.isAncestorOf(focus)) {
    // The same line's button, or another here, or the list: not what Qt finds next, which may arm.
    body_->show();
    QWidget* keeper = body_->findChild<QToolButton*>(focus->objectName());
    if (keeper == nullptr) keeper = body_->findChild<QToolButton*>();
    (keeper != nullptr ? keeper : this)->setFocus(Qt::OtherFocusReason);
  }
  former.hide();
  for (QToolButton* each : former.findChildren<QToolButton*>()) {
    each->setFocusPolicy(Qt::NoFocus);
    each->setObjectName({});
  }
  former.deleteLater();  // one of its buttons may be the caller
}

void ReadinessList::placeInTabOrder() {
  QWidget* before = previousInFocusChain();
  while (before != this && !(before->focusPolicy() & Qt::TabFocus)) before = before->previousInFocusChain();
  if (before == this) return;
  for (QToolButton* each : body_->findChildren<QToolButton*>()) {
    setTabOrder(before, each);
    before = each;
  }
}

void ReadinessList::addTrouble(QGridLayout& grid, const ReadinessRow& row, int& line) {
  const auto add = [&](const QString& words, const char* role) {
    if (words.isEmpty()) return;
    auto* label = new QLabel(words, body_);
    label->setFont(textFont(TextSize::small));
    label->setWordWrap(true);
    label->setProperty("role", role);
    grid.addWidget(label, line++, 1);
  };
  add(row.why, "warning");
  add(row.remedy, "muted");
  if (row.command.isEmpty()) return;
  auto* button = new QToolButton(body_);
  button->setObjectName(QStringLiteral("mend_") + row.command);
  button->setText(row.action);
  button->setFont(textFont(TextSize::small));
  button->setAccessibleName(tr("%1: %2").arg(row.what, row.action));
  connect(button, &QToolButton::clicked, this, [this, id = row.command] { emit commandAsked(id); });
  grid.addWidget(button, line++, 1, Qt::AlignLeft);
}

}  // namespace fyd::widgets
