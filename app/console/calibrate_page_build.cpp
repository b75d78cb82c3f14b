// How the place "Calibrate" is laid out.
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "app/console/calibrate_page.h"
#include "widgets/icon.h"
#include "widgets/theme.h"

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

QPushButton* button(QWidget* parent, const char* name, const QString& text, const QString& tip) {
  auto* out = new QPushButton(text, parent);
  out->setObjectName(QLatin1String(name));
  out->setToolTip(tip);
  out->setAutoDefault(false);
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
  layout->addWidget(buildButtons());
}

QWidget* CalibratePage::buildLeft() {
  QVBoxLayout* layout = nullptr;
  QFrame* out = panel(this, layout);
  out->setFixedWidth(32 * kGrid);
  auto* title = new QLabel(tr("Can I trust the sensors?"), out);
  title->setFont(widgets::textFont(TextSize::normal, true));
  parts_ = new QListWidget(out);
  parts_->setObjectName(QStringLiteral("calibration_parts"));
  parts_->setAccessibleName(tr("Parts and the age of their calibration"));
  parts_->setWordWrap(true);
  parts_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
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

QWidget* CalibratePage::buildButtons() {
  auto* out = new QFrame(this);
  out->setProperty("surface", "panel");
  auto* row = new QHBoxLayout(out);
  row->setContentsMargins(2 * kGrid, kGrid, 2 * kGrid, kGrid);
  row->setSpacing(kGrid);
  back_ = button(out, "calibrate_back", tr("Back"), tr("Takes the last point back."));
  take_ = button(out, "calibrate_take", tr("Take point"), tr("Averages the signal and adds it to the points."));
  move_ = new widgets::HoldButton(tr("Hold to move"), out);
  move_->setObjectName(QStringLiteral("calibrate_move"));
  move_->setAccessibleName(tr("Hold to move the motors"));
  move_->setToolTip(
      tr("The motors move as long as this is held, by mouse or space bar, and are off when it is let go."));
  report_ = button(out, "calibrate_report", tr("Report"),
                   tr("Writes this part's last calibration, before and after, as a PDF beside the profile."));
  simulate_ = button(out, "calibrate_simulate", tr("Take simulated points"),
                     tr("Points as the simulated touchpad gives them; the record says that they are simulated."));
  discard_ =
      button(out, "calibrate_discard", tr("Discard"), tr("Forgets this part's points; the values in force stay."));
  accept_ = button(out, "calibrate_accept", tr("Accept"),
                   tr("Writes the new values with their record, and begins the session anew with them."));
  why_still_ = new QLabel(tr("Only while nothing renders: press Esc first."), out);
  why_still_->setObjectName(QStringLiteral("calibrate_why_still"));
  why_still_->setProperty("role", "muted");
  why_still_->setWordWrap(true);
  why_still_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  QSizePolicy room = why_still_->sizePolicy();
  room.setRetainSizeWhenHidden(true);  // the buttons stay at the right; notices slide in at the left
  why_still_->setSizePolicy(room);
  row->addWidget(why_still_, 1);
  row->addWidget(back_);
  row->addWidget(take_);
  row->addWidget(move_);
  row->addWidget(simulate_);
  row->addWidget(report_);
  row->addWidget(discard_);
  row->addWidget(accept_);
  connect(back_, &QPushButton::clicked, this, &CalibratePage::takeBack);
  connect(take_, &QPushButton::clicked, this, &CalibratePage::startPoint);
  connect(move_, &widgets::HoldButton::held, this, &CalibratePage::startMotion);
  connect(move_, &widgets::HoldButton::letGo, this, &CalibratePage::endMotion);
  connect(report_, &QPushButton::clicked, this, &CalibratePage::writeReport);
  connect(simulate_, &QPushButton::clicked, this, &CalibratePage::simulate);
  connect(discard_, &QPushButton::clicked, this, &CalibratePage::discard);
  connect(accept_, &QPushButton::clicked, this, &CalibratePage::accept);
  return out;
}

}  // namespace fyd::console
