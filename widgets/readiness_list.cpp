#include "widgets/readiness_list.h"

#include <QGridLayout>

#include "widgets/icon.h"
#include "widgets/theme.h"

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
  delete body_;
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
    what->setAccessibleName(row.what + (row.ok ? tr(": yes") : tr(": no. ") + row.remedy));
    grid->addWidget(mark, line, 0, Qt::AlignTop);
    grid->addWidget(what, line++, 1);
    if (!row.ok && !row.remedy.isEmpty()) {
      auto* remedy = new QLabel(row.remedy, body_);
      remedy->setFont(textFont(TextSize::small));
      remedy->setWordWrap(true);
      remedy->setProperty("role", "muted");
      grid->addWidget(remedy, line++, 1);
    }
  }
  layout_->addWidget(body_);
  setAccessibleDescription(title_->text());
}

}  // namespace fyd::widgets
