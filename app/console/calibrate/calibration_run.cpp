#include "app/console/calibrate/calibration_run.h"

#include <QTimer>

#include "core/calibration/calibration_dependence.h"
#include "core/calibration/stiffness_map.h"
#include "core/device/touchpad/test_motion.h"
#include "core/station/profile/calibration_file.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"

namespace fyd::console {

using pipeline::SafetyState;

namespace {

constexpr int kLiftedFinger_ms = 1000;  // until the camera has seen the simulated finger leave

/// Number of readings in the live figures: those of 1 s, or of one point when points are taken automatically.
int liveReadings(const CalibrationStep& step) {
  constexpr int kSecond_ms = 1000;
  return step.motion() != CalibrationStep::Motion::none ? step.readings() : kSecond_ms / step.interval_ms();
}

}  // namespace

CalibrationRun::CalibrationRun(const PageContext& context, widgets::HoldButton* move_button, QObject* parent)
    : QObject(parent),
      context_(context),
      motion_(new HeldMotion(context.session, move_button, this)),
      profile_(context.session.currentProfile()),
      steps_(makeCalibrationSteps(profile_)) {
  connect(move_button, &widgets::HoldButton::letGo, motion_, &HeldMotion::end);
  connect(motion_, &HeldMotion::ended, this, [this] {
    if (const auto unfinished = std::exchange(sweep_of_, std::nullopt)) {
      points_.clear(*unfinished);
      emit said(tr("The motors are off. The sweep was not finished: its points are left out."), false);
      refit();
    } else {
      emit said(tr("The motors are off. %1 points so far.").arg(points().size()), false);
    }
    emit motionEnded();
    emit allowedChanged();
  });
  const SessionFeed* feed = &context_.feed;
  connect(feed, &SessionFeed::telemetry, this, [this](std::span<const pipeline::TelemetrySample> samples) {
    newest_ = samples.back();
    if (std::exchange(state_, newest_.state) != newest_.state) emit allowedChanged();
  });
  connect(feed, &SessionFeed::silent, this, [this](bool silent) {
    silent_ = silent;
    emit allowedChanged();
  });
}

double CalibrationRun::progress() const {
  if (taking_now_) return taking_.progress();
  return motion_->active() && step().motion() == CalibrationStep::Motion::experiment ? motion_->status().progress : 0.0;
}

bool CalibrationRun::mayMove() const {
  return !silent_ &&
         (state_ == SafetyState::connected || state_ == SafetyState::ready || state_ == SafetyState::stopped);
}

QString CalibrationRun::whyStill() const {
  if (silent_ || mayMove()) return {};
  return state_ == SafetyState::disconnected ? tr("Only with motors that answer.")
                                             : tr("Only while nothing renders: press Esc first.");
}

void CalibrationRun::takeProfile() {
  profile_ = context_.session.currentProfile();
  for (const auto& each : steps_) each->takeProfile(profile_);
  refit();
}

void CalibrationRun::takeTare() {
  if (taking_now_) endPoint(tr("Not taken: a tare came in between. Take the point again."));
  restartReadings();
  takeProfile();
}

void CalibrationRun::forgetTared() { discardReadWith("no-touch"); }

void CalibrationRun::discardReadWith(std::string_view procedure) {
  QStringList lost;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const int part = static_cast<int>(i);
    if (points_.of(part).empty() || !steps_[i]->readWith(procedure)) continue;
    lost << counted(part);
    points_.clear(part);
  }
  if (lost.isEmpty()) return;
  context_.tell(widgets::Severity::warning,
                tr("Calibration points read with the former values are discarded: take them again (%1).")
                    .arg(lost.join(QStringLiteral(", "))));
}

void CalibrationRun::changeDevices() {
  end();
  if (const QStringList lost = unaccepted(); !lost.isEmpty()) {
    context_.tell(widgets::Severity::warning,
                  tr("Other devices are connected: calibration points of the former ones are discarded (%1).")
                      .arg(lost.join(QStringLiteral(", "))));
  }
  points_.clear();
  restartReadings();
  takeProfile();
}

void CalibrationRun::choose(int step) {
  end();
  step_ = step;
  restartReadings();
  emit said({}, false);
  refit();
}

void CalibrationRun::end() {
  motion_->end();
  endPoint({});
}

void CalibrationRun::restartReadings() { recent_.restart(liveReadings(step())); }

CalibrationScene CalibrationRun::scene(const Picks& picks) const {
  return {.devices = devices_,
          .newest = newest_,
          .finger = finger_,
          .profile = profile_,
          .picture = picks.picture,
          .place_px = picks.place_px,
          .rectangle_px = picks.rectangle_px,
          .motion = motion_->status()};
}

Result<std::vector<double>> CalibrationRun::read(const Picks& picks) {
  devices_ = context_.session.devices();
  motion_->readStatus();
  finger_ = context_.session.cameraView().finger;
  auto reading = step().read(scene(picks));
  if (reading) {
    recent_.add(*reading, step().signalsWanted(profile_));
    return reading;
  }
  restartReadings();
  if (taking_now_) endPoint(tr("Not taken: %1.").arg(widgets::coreText(reading.error().message)));
  return reading;
}

void CalibrationRun::advance(const Picks& picks, const std::vector<double>& reading) {
  if (step().motion() != CalibrationStep::Motion::none) takeByItself(picks);
  if (!taking_now_) return;
  const auto wanted = step().signalsWanted(profile_);
  taking_.add(reading, wanted);
  if (!taking_.full()) return;
  const QString moves = taking_.moving(wanted);
  if (moves.isEmpty()) {
    takePoint();
  } else {
    endPoint(tr("Not taken: %1. Wait until it rests and take the point again.").arg(moves));
  }
}

PointOrigin CalibrationRun::originOfReadings() const {
  return context_.session.simulated() ? PointOrigin::measured_on_simulation : PointOrigin::measured;
}

QString CalibrationRun::otherOrigin(PointOrigin origin) const {
  if (points().empty() || points_.originOf(step_) == origin) return {};
  if (points_.originOf(step_) == PointOrigin::simulated) {
    return tr("These points are simulated: discard them before you measure.");
  }
  if (origin == PointOrigin::simulated) {
    return tr("These points are measured: discard them before you take simulated ones.");
  }
  return origin == PointOrigin::measured
             ? tr("These points were measured on the simulated touchpad: discard them before you measure on this one.")
             : tr("These points were measured on another touchpad: discard them before you measure on the simulated "
                  "one.");
}

void CalibrationRun::startPoint(const Picks& picks, const Entered& entered) {
  if (taking_now_) return;
  if (step().motion() != CalibrationStep::Motion::none) {
    emit said(tr("This part's points are taken by themselves while the button is held."), true);
    return;
  }
  const QString mixed = otherOrigin(lifted_ ? PointOrigin::simulated : originOfReadings());
  if (!mixed.isEmpty() && !step().onePoint()) {
    emit said(mixed, true);
    return;
  }
  if (!entered) {
    emit said(tr("Not taken: see the entry at the left."), true);
    return;
  }
  entered_ = *entered;
  devices_ = context_.session.devices();
  finger_ = context_.session.cameraView().finger;
  const auto reading = step().read(scene(picks));
  if (!reading) {
    endPoint(tr("Not taken: %1.").arg(widgets::coreText(reading.error().message)));
    return;
  }
  taking_.restart(step().readings());
  if (step().readings() == 1) {
    taking_.add(*reading, step().signalsWanted(profile_));
    takePoint();
    return;
  }
  taking_now_ = true;
  emit said(tr("Averaging for %1 s: keep still.")
                .arg(widgets::plainNumber(step().readings() * step().interval_ms() / 1000.0)),
            false);
  emit allowedChanged();
}

void CalibrationRun::endPoint(const QString& why_not) {
  if (lifted_) context_.session.releaseSimulatedFinger();
  lifted_ = false;
  taking_now_ = false;
  if (!why_not.isEmpty()) emit said(why_not, true);
  emit allowedChanged();
}

void CalibrationRun::takePoint() {
  if (step().onePoint()) points_.clear(step_);
  CalibrationPoint whole = step().pointOf(taking_.readings());
  points_.add(step_, whole.empty() ? step().point(entered_, taking_.mean(), taking_.spread()) : std::move(whole),
              lifted_ ? PointOrigin::simulated : originOfReadings());
  endPoint({});
  emit said(step().onePoint() ? tr("Measured.") : tr("Point %1 taken.").arg(points().size()), false);
  refit();
  emit pointTaken(true);
}

void CalibrationRun::takeBack() {
  if (points().empty() || taking_now_) return;
  points_.takeBack(step_);
  emit said(tr("The last point is taken back."), false);
  refit();
}

void CalibrationRun::discard() {
  if (points().empty() && !taking_now_) return;
  endPoint({});
  points_.clear(step_);
  emit said(tr("Points discarded; the values in force stay."), false);
  refit();
}

void CalibrationRun::simulate() {
  if (taking_now_ || lifted_) return;
  if (!context_.session.simulated()) {
    emit said(tr("The touchpad is not simulated: take its points by measuring."), true);
    return;
  }
  if (const QString mixed = otherOrigin(PointOrigin::simulated); !mixed.isEmpty()) {
    emit said(mixed, true);
    return;
  }
  auto simulated = step().simulatedPoints(profile_);
  if (!simulated.empty()) {
    points_.clear(step_);
    for (CalibrationPoint& point : simulated) points_.add(step_, std::move(point), PointOrigin::simulated);
    emit said(tr("Simulated points, from the simulator's own truth and noise. No part was measured."), false);
    refit();
    return;
  }
  lifted_ = true;
  context_.session.moveSimulatedFinger(0.0, 0.0, 0.0);
  emit said(tr("The simulated finger leaves the cloth…"), false);
  QTimer::singleShot(kLiftedFinger_ms, this, [this] {
    if (lifted_) emit fingerLifted();
  });
}

void CalibrationRun::startMotion(const Entered& entered) {
  if (const QString mixed = otherOrigin(originOfReadings()); !mixed.isEmpty()) {
    emit said(mixed, true);
    return;
  }
  if (!entered) {
    emit said(tr("Not moved: see the entry at the left."), true);
    return;
  }
  const device::DeviceTest test = step().test(points());
  const auto started = motion_->start(test, device::goesToStretch(test) && !entered->empty() ? entered->front() : 0.0);
  if (!started) {
    emit said(tr("Not moved: %1.").arg(widgets::coreText(started.error().message)), true);
    return;
  }
  if (test == device::DeviceTest::sweep) {  // it is only used complete
    points_.clear(step_);
    sweep_of_ = step_;
  }
  entered_ = *entered;
  recent_.restart(step().readings());
  emit said(tr("The motors move; let go and they are off."), false);
  refit();
}

void CalibrationRun::takeByItself(const Picks& picks) {
  if (!motion_->active()) return;
  if (!motion_->status().running) {
    const station::DeviceTestStatus ended = motion_->status();
    if (ended.finished) {
      takeExperiment();
      sweep_of_.reset();
    }
    motion_->end();
    emit said(tr("The motors are off: %1. %2 points so far.").arg(widgets::coreText(ended.words)).arg(points().size()),
              !ended.finished);
    return;
  }
  if (step().motion() == CalibrationStep::Motion::experiment) {
    (void)context_.session.deviceTestSweep();
    return;
  }
  const auto wanted = step().signalsWanted(profile_);
  const QString moving = recent_.full() ? recent_.moving(wanted) : QString();
  const QString not_yet = step().notYet(scene(picks), points(), recent_.mean());
  if (!not_yet.isEmpty() || !moving.isEmpty() || !recent_.full()) {
    emit said(!not_yet.isEmpty() ? not_yet : !moving.isEmpty() ? moving + QLatin1Char('.') : tr("Hold still."), false);
    if (!not_yet.isEmpty()) recent_.restart(step().readings());
    return;
  }
  points_.add(step_, step().point(entered_, recent_.mean(), recent_.spread()), originOfReadings());
  emit said(tr("Point %1 taken.").arg(points().size()), false);
  recent_.restart(step().readings());
  refit();
  emit pointTaken(false);
}

void CalibrationRun::takeExperiment() {
  CalibrationPoint point = step().pointOfExperiment(context_.session.deviceTestSweep());
  if (point.empty()) return;
  points_.add(step_, std::move(point), originOfReadings());
  refit();
}

QStringList CalibrationRun::unaccepted() const {
  QStringList out;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (!points_.of(static_cast<int>(i)).empty()) out << counted(static_cast<int>(i));
  }
  return out;
}

QString CalibrationRun::counted(int part) const {
  return tr("%1 %2").arg(steps_[static_cast<std::size_t>(part)]->name()).arg(points_.of(part).size());
}

void CalibrationRun::refit() {
  fit_ = step().fit(points(), profile_);
  if (step().trustsIndentation() && !points().empty()) {
    const auto records = station::loadCalibrationRecords(context_.tuning.profilePath().toStdString());
    if (!records ||
        !calibration::clothProven(station::recordsFor(*records, profile_.calibrated_on), bindParameters(profile_))) {
      calibration::sayIndentationUnproven(fit_.result);
    }
  }
  emit fitted();
}

void CalibrationRun::accept(const AcceptedWords& words) {
  if (points().empty() || !fit_.result.verdict.accepted) {
    emit said(tr("There is nothing to accept yet: %1.")
                  .arg(points().empty() ? tr("take points first") : widgets::coreText(fit_.result.verdict.reason)),
              true);
    return;
  }
  if (silent_ || !context_.session.isOpen()) {  // not open: the devices are being changed
    emit said(tr("The station is silent: wait until it answers."), true);
    return;
  }
  const bool anew = !fit_.result.changes.empty();
  if (anew && (newest_.state == SafetyState::active || newest_.state == SafetyState::held || motion_->active())) {
    emit said(tr("Accepting begins the session anew, and that is not done while motors can move: press Esc first."),
              true);
    return;
  }
  if (anew && context_.session.recorderStatus().state == recording::RecorderState::recording) {
    emit said(tr("Accepting begins the session anew and would end the recording: stop the recording first."), true);
    return;
  }
  if (context_.connection.recorderWaits()) {
    emit said(ConnectionChange::recorderWaitsText(), true);
    return;
  }
  if (words.who.empty()) {
    emit said(tr("Who measured? Write your name at the right, then accept."), true);
    emit nameMissing();
    return;
  }
  AcceptedWords record = words;
  if (points_.originOf(step_) != PointOrigin::measured) {
    record.simulated = true;
    record.conditions =
        std::string(calibration::kSimulatedPoints) + (record.conditions.empty() ? "" : "; " + record.conditions);
  }
  // A copy: a tare that is heard meanwhile fits what is left of the points.
  const calibration::CalibrationResult judged = fit_.result;
  const Acceptance accepted_as = acceptCalibration(context_, judged, step().sensor(), record);
  if (accepted_as == Acceptance::refused) return;
  points_.clear(step_);
  if (accepted_as == Acceptance::in_force) discardReadWith(step().procedure());
  takeProfile();
  emit said(accepted_as == Acceptance::in_force ? tr("Accepted. The values are in force and in the profile.")
                                                : tr("Accepted. The values are in the profile, not in force."),
            false);
  emit accepted();
}

void CalibrationRun::writeReport() {
  const QString problem = writeCalibrationReport(context_, step().procedure(), step().sensor());
  emit said(problem.isEmpty() ? tr("The report stands beside the profile.") : tr("No report: %1.").arg(problem),
            !problem.isEmpty());
}

}  // namespace fyd::console
