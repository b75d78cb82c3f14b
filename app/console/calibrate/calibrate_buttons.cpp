#include "app/console/calibrate/calibrate_buttons.h"

#include <QHBoxLayout>

#include "widgets/basics/theme.h"

namespace fyd::console {

using widgets::kGrid;

CalibrationButtons::CalibrationButtons(QWidget* parent) : QFrame(parent) {
  setProperty("surface", "panel");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(2 * kGrid, kGrid, 2 * kGrid, kGrid);
  row->setSpacing(kGrid);
  why_still_ = new QLabel(this);
  back_ = add("calibrate_back", tr("Back"), tr("Takes the last point back."));
  take_ = add("calibrate_take", tr("Take point"), tr("Averages the signal and adds it to the points."));
  move_ = new widgets::HoldButton(tr("Hold to move"), this);
  move_->setObjectName(QStringLiteral("calibrate_move"));
  move_->setAccessibleName(tr("Hold to move the motors"));
  move_->setToolTip(
      tr("The motors move as long as this is held, by mouse or space bar, and are off when it is let go."));
  report_ = add("calibrate_report", tr("Report"),
                tr("Writes this part's last calibration, before and after, as a PDF beside the profile."));
  simulate_ = add("calibrate_simulate", tr("Take simulated points"),
                  tr("Points as the simulated touchpad gives them; the record says that they are simulated."));
  discard_ = add("calibrate_discard", tr("Discard"), tr("Forgets this part's points; the values in force stay."));
  accept_ = add("calibrate_accept", tr("Accept"),
                tr("Writes the new values with their record, and begins the session anew with them."));
  why_still_->setObjectName(QStringLiteral("calibrate_why_still"));
  why_still_->setProperty("role", "muted");
  why_still_->setWordWrap(true);
  why_still_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  QSizePolicy space = why_still_->sizePolicy();
  space.setRetainSizeWhenHidden(true);  // the buttons stay at the right; notices slide in at the left
  why_still_->setSizePolicy(space);
  row->addWidget(why_still_, 1);
  for (QWidget* each : {static_cast<QWidget*>(back_), static_cast<QWidget*>(take_), static_cast<QWidget*>(move_),
                        static_cast<QWidget*>(simulate_), static_cast<QWidget*>(report_),
                        static_cast<QWidget*>(discard_), static_cast<QWidget*>(accept_)}) {
    row->addWidget(each);
  }
}

QPushButton* CalibrationButtons::add(const char* name, const QString& text, const QString& tip) {
  auto* out = new QPushButton(text, this);
  out->setObjectName(QLatin1String(name));
  out->setToolTip(tip);
  out->setAutoDefault(false);
  return out;
}

void CalibrationButtons::allow(const Allowed& allowed) {
  take_->setVisible(!allowed.moves);
  move_->setVisible(allowed.moves);
  move_->setEnabled(allowed.may_move);
  why_still_->setText(allowed.why_still);
  why_still_->setVisible(allowed.moves && !allowed.why_still.isEmpty());
  report_->setEnabled(!allowed.taking);
  take_->setEnabled(!allowed.taking);
  simulate_->setEnabled(!allowed.taking);
  back_->setEnabled(allowed.has_points && !allowed.taking);
  discard_->setEnabled(allowed.has_points || allowed.taking);
  accept_->setEnabled(allowed.has_points && !allowed.taking && allowed.acceptable);
}

}  // namespace fyd::console
