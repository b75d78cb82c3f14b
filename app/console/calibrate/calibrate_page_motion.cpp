// Calibration of parts that need motor motion: only while the operator holds the button. Points are taken automatically
// meanwhile, because one hand holds the button and the other may press the cloth.
#include "app/console/calibrate/calibrate_page.h"
#include "core/device/touchpad/test_motion.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"

namespace fyd::console {

void CalibratePage::startMotion() {
  if (points_.holdsSimulated(step_)) {
    say(tr("These points are simulated: discard them before you measure."), true);
    return;
  }
  const auto entered = entries_->read();
  if (!entered) {
    say(tr("Not moved: see the entry at the left."), true);
    return;
  }
  const device::DeviceTest test = step().test(points());
  const auto started = motion_->start(test, device::goesToStretch(test) && !entered->empty() ? entered->front() : 0.0);
  if (!started) {
    say(tr("Not moved: %1.").arg(widgets::coreText(started.error().message)), true);
    return;
  }
  if (test == device::DeviceTest::sweep) points_.clear(step_);  // a sweep is only used complete
  recent_.restart(step().readings());
  say(tr("The motors move; let go and they are off."), false);
  refit();
}

void CalibratePage::showMotionEnded() {
  say(tr("The motors are off. %1 points so far.").arg(points().size()), false);
  offerNext();
  refreshButtons();
}

void CalibratePage::takeByItself(const std::vector<CalibrationSignal>& wanted) {
  if (!motion_->active()) return;
  if (!motion_->status().running) {
    const station::DeviceTestStatus ended = motion_->status();
    if (ended.finished) takeExperiment();
    motion_->end();
    say(tr("The motors are off: %1. %2 points so far.").arg(widgets::coreText(ended.words)).arg(points().size()),
        !ended.finished);
    return;
  }
  if (step().motion() == CalibrationStep::Motion::experiment) {
    (void)context_.session.deviceTestSweep();
    progress_->setValue(static_cast<int>(100.0 * motion_->status().progress));
    return;
  }
  const QString moving = recent_.full() ? recent_.moving(wanted) : QString();
  const QString not_yet = step().notYet(scene(), points(), recent_.mean());
  if (!not_yet.isEmpty() || !moving.isEmpty() || !recent_.full()) {
    say(!not_yet.isEmpty() ? not_yet : !moving.isEmpty() ? moving + QLatin1Char('.') : tr("Hold still."), false);
    if (!not_yet.isEmpty()) recent_.restart(step().readings());
    return;
  }
  points_.add(step_, step().point(entered_, recent_.mean(), recent_.spread()), originOfReadings());
  trace_->mark();
  say(tr("Point %1 taken.").arg(points().size()), false);
  recent_.restart(step().readings());
  refit();
}

void CalibratePage::takeExperiment() {
  CalibrationPoint point = step().pointOfExperiment(context_.session.deviceTestSweep());
  if (point.empty()) return;
  points_.add(step_, std::move(point), originOfReadings());
  refit();
}

void CalibratePage::offerNext() {
  const double next = step().offer(points());
  if (step().entries().empty() || step().motion() == CalibrationStep::Motion::none) return;
  if (std::isfinite(next)) entries_->field(0)->setText(widgets::plainNumber(next));
}

}  // namespace fyd::console
