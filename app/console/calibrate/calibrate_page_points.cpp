// How points of the place "Calibrate" are taken, taken back, discarded and accepted.
#include "app/console/calibrate/calibrate_page.h"

#include "widgets/basics/core_text.h"

namespace fyd::console {
namespace {

constexpr int kLiftedFinger_ms = 1000;  // until the camera has seen the simulated finger leave

}  // namespace

PointOrigin CalibratePage::originOfReadings() const {
  return context_.session.simulated() ? PointOrigin::measured_on_simulation : PointOrigin::measured;
}

void CalibratePage::startPoint() {
  if (taking_now_) return;
  if (step().motion() != CalibrationStep::Motion::none) {
    say(tr("This part's points are taken by themselves while the button is held."), true);
    return;
  }
  if (points_.holdsSimulated(step_) && !lifted_ && !step().onePoint()) {
    say(tr("These points are simulated: discard them before you measure."), true);
    return;
  }
  const auto entered = entries_->read();
  if (!entered) {
    say(tr("Not taken: see the entry at the left."), true);
    return;
  }
  entered_ = *entered;
  devices_ = context_.session.devices();
  finger_ = context_.session.cameraView().finger;
  const auto reading = step().read(scene());
  if (!reading) {
    endPoint(tr("Not taken: %1.").arg(widgets::coreText(reading.error().message)));
    return;
  }
  taking_.restart(step().readings());
  if (step().readings() == 1) {
    taking_.add(*reading);
    takePoint();
    return;
  }
  taking_now_ = true;
  say(tr("Averaging for %1 s: keep still.").arg(step().readings() * step().interval_ms() / 1000.0), false);
  refreshButtons();
}

void CalibratePage::endPoint(const QString& why_not) {
  if (lifted_) context_.session.releaseSimulatedFinger();
  lifted_ = false;
  taking_now_ = false;
  progress_->setValue(0);
  if (!why_not.isEmpty()) say(why_not, true);
  if (step_known_) refreshButtons();
}

void CalibratePage::takePoint() {
  if (step().onePoint()) points_.clear(step_);
  CalibrationPoint whole = step().pointOf(taking_.readings());
  points_.add(step_, whole.empty() ? step().point(entered_, taking_.mean(), taking_.spread()) : std::move(whole),
              lifted_ ? PointOrigin::simulated : PointOrigin::measured);
  trace_->mark();
  endPoint({});
  entries_->clear();
  picture_->setPlace({});
  say(step().onePoint() ? tr("Measured.") : tr("Point %1 taken.").arg(points().size()), false);
  refit();
  if (!step().entries().empty()) entries_->field(0)->setFocus();
}

void CalibratePage::takeBack() {
  if (points().empty() || taking_now_) return;
  points_.takeBack(step_);
  say(tr("The last point is taken back."), false);
  refit();
}

void CalibratePage::discard() {
  if (points().empty() && !taking_now_) return;
  endPoint({});
  points_.clear(step_);
  say(tr("Points discarded; the values in force stay."), false);
  refit();
  offerNext();
}

void CalibratePage::simulate() {
  if (taking_now_ || lifted_) return;
  if (!points().empty() && !points_.holdsSimulated(step_)) {
    say(tr("These points are measured: discard them before you take simulated ones."), true);
    return;
  }
  auto simulated = step().simulatedPoints(profile_);
  if (!simulated.empty()) {
    points_.clear(step_);
    for (CalibrationPoint& point : simulated) points_.add(step_, std::move(point), PointOrigin::simulated);
    say(tr("Simulated points, from the simulator's own truth and noise. No part was measured."), false);
    refit();
    offerNext();
    return;
  }
  lifted_ = true;
  context_.session.moveSimulatedFinger(0.0, 0.0, 0.0);
  say(tr("The simulated finger leaves the cloth…"), false);
  QTimer::singleShot(kLiftedFinger_ms, this, [this] {
    if (lifted_) startPoint();
  });
}

void CalibratePage::accept() {
  if (points().empty() || !fit_.result.verdict.accepted) {
    say(tr("There is nothing to accept yet: %1.")
            .arg(points().empty() ? tr("take points first") : widgets::coreText(fit_.result.verdict.reason)),
        true);
    return;
  }
  if (can_move_ || silent_) {
    say(silent_ ? tr("The station is silent: wait until it answers.")
                : tr("Accepting begins the session anew, and that is not done while motors can move: press Esc first."),
        true);
    return;
  }
  if (context_.session.recorderStatus().state == recording::RecorderState::recording) {
    say(tr("Accepting begins the session anew and would end the recording: stop the recording first."), true);
    return;
  }
  AcceptedWords record = fit_panel_->words();
  if (points_.originOf(step_) != PointOrigin::measured)
    record.conditions = "simulated points" + (record.conditions.empty() ? "" : "; " + record.conditions);
  if (!acceptCalibration(context_, fit_.result, step().sensor(), record)) return;
  points_.clear(step_);
  profile_ = context_.session.currentProfile();
  say(tr("Accepted. The values are in force and in the profile."), false);
  parts_->refresh(steps_, context_.tuning.profilePath(), profile_);
  refit();
}

void CalibratePage::writeReport() {
  const QString problem = writeCalibrationReport(context_, step().procedure(), step().sensor());
  say(problem.isEmpty() ? tr("The report stands beside the profile.") : tr("No report: %1.").arg(problem),
      !problem.isEmpty());
}

}  // namespace fyd::console
