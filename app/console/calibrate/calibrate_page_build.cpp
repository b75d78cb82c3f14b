// The layout of the place "Calibrate".
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "app/console/calibrate/calibrate_page.h"
#include "widgets/basics/icon.h"
#include "widgets/basics/theme.h"

namespace fyd::console {

using widgets::kGrid;
using widgets::TextSize;

namespace {

QFrame* panel(QWidget* parent, QVBoxLayout*& layout) {
  auto* out = new QFrame(parent);
  out->setProperty("surface", "panel");
  layout = new QVBoxLayout(out);
  layout->setContentsMargins(2 * kGrid, kGrid, 2 * kGrid, kGrid);
  layout->setSpacing(kGrid);
  return out;
}

}  // namespace

void CalibratePage::build() {
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid);
  row->addWidget(buildLeft());
  row->addWidget(buildMiddle(), 2);
  fit_panel_ = new CalibrationFitPanel(this);
  row->addWidget(fit_panel_, 3);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  layout->addLayout(row, 1);
  buttons_ = new CalibrationButtons(this);
  layout->addWidget(buttons_);
}

QWidget* CalibratePage::buildLeft() {
  QVBoxLayout* layout = nullptr;
  QFrame* out = panel(this, layout);
  out->setFixedWidth(32 * kGrid);
  auto* title = new QLabel(tr("Can I trust the sensors?"), out);
  title->setFont(widgets::textFont(TextSize::normal, true));
  parts_ = new CalibrationPartList(out);
  auto* now = new QLabel(tr("What to do now"), out);
  now->setFont(widgets::textFont(TextSize::small));
  now->setProperty("role", "muted");
  drawing_ = new QLabel(out);
  drawing_->setObjectName(QStringLiteral("calibration_drawing"));
  instruction_ = new QLabel(out);
  instruction_->setObjectName(QStringLiteral("calibration_instruction"));
  instruction_->setFont(widgets::textFont(TextSize::normal, true));
  instruction_->setWordWrap(true);
  entries_ = new CalibrationEntryForm(out);
  layout->addWidget(title);
  layout->addWidget(parts_, 1);
  layout->addWidget(now);
  layout->addWidget(drawing_);
  layout->addWidget(instruction_);
  layout->addWidget(entries_);
  return out;
}

QWidget* CalibratePage::buildMiddle() {
  QVBoxLayout* layout = nullptr;
  QFrame* out = panel(this, layout);
  picture_ = new widgets::PicturePick(out);
  live_ = new QLabel(out);
  live_->setObjectName(QStringLiteral("calibration_live"));
  live_->setFont(widgets::textFont(TextSize::title));
  live_->setWordWrap(true);
  progress_ = new QProgressBar(out);
  progress_->setTextVisible(false);
  progress_->setRange(0, 100);
  progress_->setFixedHeight(kGrid / 2);
  progress_->setAccessibleName(tr("Averaging"));
  hint_ = new QLabel(out);
  hint_->setObjectName(QStringLiteral("calibration_hint"));
  hint_->setWordWrap(true);
  trace_ = new widgets::LiveTrace(out);
  table_ = new widgets::HeadingTable(out);
  table_->setObjectName(QStringLiteral("calibration_points"));
  table_->setAccessibleName(tr("Points taken"));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->horizontalHeader()->setFont(widgets::textFont(TextSize::small));
  missing_ = new QLabel(out);
  missing_->setObjectName(QStringLiteral("calibration_missing"));
  missing_->setWordWrap(true);
  missing_->setProperty("role", "muted");
  layout->addWidget(picture_, 3);
  layout->addWidget(live_);
  layout->addWidget(progress_);
  layout->addWidget(hint_);
  layout->addWidget(trace_, 2);
  layout->addWidget(table_, 2);
  layout->addWidget(missing_);
  return out;
}

}  // namespace fyd::console
