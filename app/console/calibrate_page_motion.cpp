// Parts for which motors move: only while the operator holds the button. Points are taken by themselves meanwhile,
// because one hand holds the button and the other may press the cloth.
#include <array>

#include "app/console/calibrate_page.h"
#include "core/device/test_motion.h"
#include "widgets/core_text.h"
#include "widgets/number_text.h"

namespace fyd::console {
namespace {

constexpr int kPress_ms = 1500;  // the simulated finger rests that long at each depth
constexpr std::array kDepths_mm = {3.0, 5.0, 7.0};

}  // namespace

void CalibratePage::startMotion() {
  if (!points().empty() && simulated_[step_]) {
    say(tr("These points are simulated: discard them before you measure."), true);
    return;
  }
  const auto entered = entries_->read();
  if (!entered) {
    say(tr("Not moved: see the entry at the left."), true);
    return;
  }
  const device::DeviceTest test = step().test(points());
  const auto started =
      context_.session.startDeviceTest(test, device::goesToStretch(test) && !entered->empty() ? entered->front() : 0.0);
  if (!started) {
    say(tr("Not moved: %1.").arg(widgets::coreText(started.error().message)), true);
    return;
  }
  if (test == device::DeviceTest::sweep) points_[step_].clear();  // it is whole or nothing
  recent_.restart(step().readings());
  hold_timer_.start();
  pressing_ = test == device::DeviceTest::stretch && context_.session.simulated();
  pressing_since_.invalidate();
  say(tr("The motors move; let go and they are off."), false);
  refit();
}

void CalibratePage::holdOn() {
  if (!move_->engaged()) {
    endMotion();
    return;
  }
  context_.session.keepDeviceTest();
  if (!pressing_ || !motion_.resting) return;
  // Nobody can press a simulated cloth by hand: its own finger does, to three depths one after the other.
  if (!pressing_since_.isValid()) pressing_since_.start();
  const auto depth = static_cast<std::size_t>(pressing_since_.elapsed() / kPress_ms) % kDepths_mm.size();
  context_.session.moveSimulatedFinger(0.0, 0.0, kDepths_mm[depth]);
}

void CalibratePage::endMotion() {
  if (!hold_timer_.isActive()) return;
  hold_timer_.stop();
  context_.session.stopDeviceTest();
  if (pressing_) context_.session.releaseSimulatedFinger();
  pressing_ = false;
  motion_ = {};
  say(tr("The motors are off. %1 points so far.").arg(points().size()), false);
  offerNext();
  refreshButtons();
}

void CalibratePage::takeByItself(const std::vector<CalibrationSignal>& wanted) {
  if (!hold_timer_.isActive()) return;
  if (!motion_.running) {
    const station::DeviceTestStatus ended = motion_;
    if (ended.finished) takeExperiment();
    endMotion();
    say(tr("The motors are off: %1. %2 points so far.").arg(widgets::coreText(ended.words)).arg(points().size()),
        !ended.finished);
    return;
  }
  if (step().motion() == CalibrationStep::Motion::experiment) {
    (void)context_.session.deviceTestSweep();
    progress_->setValue(static_cast<int>(100.0 * motion_.progress));
    return;
  }
  const QString moving = recent_.full() ? recent_.moving(wanted) : QString();
  const QString not_yet = step().notYet(scene(), points(), recent_.mean());
  if (!not_yet.isEmpty() || !moving.isEmpty() || !recent_.full()) {
    say(!not_yet.isEmpty() ? not_yet : !moving.isEmpty() ? moving + QLatin1Char('.') : tr("Hold still."), false);
    if (!not_yet.isEmpty()) recent_.restart(step().readings());
    return;
  }
  points_[step_].push_back(step().point(entered_, recent_.mean(), recent_.spread()));
  simulated_[step_] = false;
  on_simulation_[step_] = context_.session.simulated();
  trace_->mark();
  say(tr("Point %1 taken.").arg(points().size()), false);
  recent_.restart(step().readings());
  refit();
}

void CalibratePage::takeExperiment() {
  CalibrationPoint point = step().pointOfExperiment(context_.session.deviceTestSweep());
  if (point.empty()) return;
  points_[step_].push_back(std::move(point));
  simulated_[step_] = false;
  on_simulation_[step_] = context_.session.simulated();
  refit();
}

void CalibratePage::offerNext() {
  const double next = step().offer(points());
  if (step().entries().empty() || step().motion() == CalibrationStep::Motion::none) return;
  if (std::isfinite(next)) entries_->field(0)->setText(widgets::plainNumber(next));
}

}  // namespace fyd::console
