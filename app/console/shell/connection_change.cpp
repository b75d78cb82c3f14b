#include "app/console/shell/connection_change.h"

#include "core/device/stable_name.h"
#include "widgets/basics/core_text.h"

namespace fyd::console {

using pipeline::SafetyState;
using widgets::Severity;

ConnectionChange::ConnectionChange(Session& session, SessionFeed& feed, TuningBridge& tuning, QObject* parent)
    : QObject(parent), session_(session), feed_(feed), tuning_(tuning) {
  connect(&feed_, &SessionFeed::telemetry, this, &ConnectionChange::hear);
  connect(&feed_, &SessionFeed::silent, this, [this](bool silent) {
    if (std::exchange(silent_, silent) != silent) emit refreshed();
  });
  connect(&feed_, &SessionFeed::recorder, this, [this](const recording::RecorderStatus& status) {
    const bool recording = status.state == recording::RecorderState::recording;
    if (std::exchange(recording_, recording) != recording) emit refreshed();
  });
  connectWork();
  tuning_.startWithTarget(present().robot == "none");  // as the station starts then
}

void ConnectionChange::connectWork() {
  connect(&opening_, &Background::runningChanged, &feed_, &SessionFeed::setConnecting);
  connect(&opening_, &Background::runningChanged, &tuning_, &TuningBridge::setConnecting);
  // What a library throws ends the work as well: devices can be chosen again.
  connect(&asking_, &Background::failed, this, [this](const QString& why) {
    show({});
    tellUnchanged(why);
  });
  connect(&opening_, &Background::failed, this,
          [this](const QString& why) { done(present(), fail(verbatim(why.toStdString()))); });
}

void ConnectionChange::tellUnchanged(const QString& why) {
  emit told(Severity::error, tr("Not connected; all is as it was. %1.").arg(why));
}

QString ConnectionChange::recorderWaitsText() {
  return tr("A recording is beginning or ending. Wait until the disk has answered.");
}

void ConnectionChange::hear(std::span<const pipeline::TelemetrySample> samples) {
  const SafetyState state = samples.back().state;
  const bool can_move = state == SafetyState::active || state == SafetyState::held;
  if (std::exchange(can_move_, can_move) != can_move) emit refreshed();
}

QString ConnectionChange::hindrance() const {
  if (!session_.isOpen()) return {};
  if (can_move_ || silent_) return tr("Devices can be changed only while nothing can move. Press Esc first.");
  if (recorder_waits_) return recorderWaitsText();
  if (recording_) return tr("A recording is under way and would end. End it first.");
  return {};
}

bool ConnectionChange::mayBegin() {
  feed_.pump();  // takes the last data of the ending session, above all its state
  return hindrance().isEmpty();
}

void ConnectionChange::show(const QString& work) {
  work_ = work;
  emit refreshed();
}

void ConnectionChange::change(const ConnectionWords& wanted) {
  if (!work_.isEmpty()) return;
  if (!mayBegin()) return emit told(Severity::warning, hindrance());
  problems_.clear();
  const bool scene = wanted.robot.starts_with("scene:") && wanted.robot != present().robot;
  asking_.run([this, wanted, check = session_.checkOf(wanted)](const std::stop_token&) -> Background::Finish {
    return [this, wanted, problems = check()] { answered(wanted, problems); };
  });
  if (!session_.isOpen()) return show(tr("Asking the devices whether they answer …"));
  show(scene ? tr("Reading the scene. The present session goes on until it is read.")
             : tr("Asking the devices whether they answer. The present session goes on meanwhile."));
}

void ConnectionChange::cancel() {
  if (!canBeCancelled()) return;
  asking_.cancel();
  show({});
}

void ConnectionChange::waitForRecorder(bool waits) {
  if (std::exchange(recorder_waits_, waits) != waits) emit refreshed();
}

void ConnectionChange::answered(const ConnectionWords& wanted, std::vector<station::ConnectionProblem> problems) {
  problems_ = std::move(problems);
  if (problems_.empty() && mayBegin()) return leaveFor(wanted);
  show({});
  if (problems_.empty()) {
    emit told(Severity::warning, tr("Not connected. %1").arg(hindrance()));
    return;
  }
  QStringList reasons;
  for (const station::ConnectionProblem& each : problems_) reasons << widgets::coreText(each.message);
  tellUnchanged(reasons.join(QStringLiteral("; ")));
}

void ConnectionChange::leaveFor(const ConnectionWords& wanted) {
  emit leaving();
  former_ = session_.currentProfile().calibrated_on;
  opening_.run([this, wanted, work = session_.leaveFor(wanted)](const std::stop_token&) -> Background::Finish {
    return [this, wanted, arrive = work()] { done(wanted, arrive()); };
  });
  show(tr("The former session has ended; the new one begins. Motors are off."));
}

void ConnectionChange::done(const ConnectionWords& wanted, const Result<void>& outcome) {
  can_move_ = true;  // until the new session says otherwise
  recording_ = false;
  feed_.restart();
  tuning_.restart(former_);
  const bool open = session_.isOpen();
  if (outcome) {
    tuning_.startWithTarget(wanted.robot == "none");
    emit arrived(wanted);
    emit told(Severity::information, tr("Connected: %1.").arg(inWords(wanted)));
  } else {
    // The former devices' station is a new one as well, and starts with the robot's target.
    if (open && tuning_.targetIsByHand()) tuning_.targetByHand();
    const QString why = widgets::coreText(outcome.error().message);
    emit told(Severity::error, open ? tr("Not connected; the former devices are back. %1.").arg(why)
                                    : tr("The session is closed. %1. Choose other devices.").arg(why));
  }
  show({});
}

QString inWords(const ConnectionWords& words) {
  const auto text = [](const std::string& word) { return widgets::coreText(word); };
  QStringList parts{ConnectionChange::tr("touchpad %1").arg(text(words.touchpad))};
  if (!words.motors.empty()) parts << ConnectionChange::tr("motors %1").arg(text(words.motors));
  if (!words.camera.empty()) parts << ConnectionChange::tr("camera %1").arg(text(device::withoutSecrets(words.camera)));
  parts << ConnectionChange::tr("robot %1").arg(text(words.robot));
  return parts.join(QStringLiteral(", "));
}

}  // namespace fyd::console
