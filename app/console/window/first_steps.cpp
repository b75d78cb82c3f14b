#include "app/console/window/first_steps.h"

#include <set>

#include "core/calibration/calibration_part.h"
#include "core/station/profile/calibration_records.h"

namespace fyd::console {

using pipeline::SafetyState;

namespace {

constexpr int kCount_ms = 1000;

int partCount() { return static_cast<int>(calibration::calibrationParts().size()); }

}  // namespace

FirstSteps::FirstSteps(const PageContext& context, const WindowMemory& memory,
                       std::function<void(const QString& place)> go, QObject* parent)
    : QObject(parent),
      context_(context),
      memory_(memory),
      go_(std::move(go)),
      strip_(new widgets::GuideStrip(tr("First steps"))),
      chosen_(memory_.devices().has_value()) {
  strip_->hide();
  counting_.setInterval(kCount_ms);
  connect(&counting_, &QTimer::timeout, this, &FirstSteps::countCalibrated);
  connect(&context_.feed, &SessionFeed::telemetry, this, &FirstSteps::hear);
  connect(&context_.connection, &ConnectionChange::arrived, this, [this] {
    chosen_ = true;
    answers_ = false;
    refresh();
  });
  connect(strip_, &widgets::GuideStrip::closeAsked, this, [this] {
    memory_.setFirstStepsOver();
    counting_.stop();
    strip_->hide();
  });
}

void FirstSteps::show() {
  countCalibrated();
  counting_.start();
  refresh();
  strip_->show();
  strip_->takeFocus();
}

void FirstSteps::hear(std::span<const pipeline::TelemetrySample> samples) {
  bool touched = touched_;
  for (const pipeline::TelemetrySample& each : samples) {
    touched = touched || (each.state == SafetyState::active && each.contact);
  }
  const bool answers = samples.back().state != SafetyState::disconnected;
  if (touched == touched_ && answers == answers_) return;
  touched_ = touched;
  answers_ = answers;
  refresh();
}

void FirstSteps::chooseSimulated() {
  const ConnectionWords simulated;
  if (context_.session.isOpen() && context_.connection.present().touchpad == simulated.touchpad) {
    chosen_ = true;
    memory_.setDevices(context_.connection.present());
    return refresh();
  }
  context_.connection.change(simulated);
}

void FirstSteps::countCalibrated() {
  const auto records = station::loadCalibrationRecords(context_.tuning.profilePath().toStdString());
  std::set<std::string> parts;
  if (records) {
    for (const auto& record : station::recordsFor(*records, context_.session.currentProfile().calibrated_on)) {
      parts.insert(record.procedure);
    }
  }
  int count = 0;
  for (const calibration::CalibrationPart& part : calibration::calibrationParts()) {
    count += parts.contains(std::string(part.procedure)) ? 1 : 0;
  }
  if (std::exchange(calibrated_, count) != count) refresh();
}

FirstSteps::Step FirstSteps::step() const {
  if (!chosen_) return choose;
  if (!answers_) return connected;
  if (touched_) return over;
  // The simulation's own values fit it; a touchpad of one's own is calibrated first.
  if (!context_.session.simulated() && calibrated_ < partCount() && !calibrates_later_) return calibrate;
  return touch;
}

void FirstSteps::refresh() {
  const Step now = step();
  if (now == over) memory_.setFirstStepsOver();
  const bool simulated = context_.session.simulated();
  const QString parts = simulated && calibrated_ == 0
                            ? tr("Calibrate (the simulation needs none)")
                            : tr("Calibrate: %1 of %2 parts").arg(calibrated_).arg(partCount());
  strip_->setGuide({{tr("Simulated or mine?"), chosen_},
                    {tr("Connect"), chosen_ && answers_},
                    {parts, calibrated_ == partCount()},
                    {tr("First touch"), touched_}},
                   now, advice(now), actions(now));
}

QString FirstSteps::advice(Step step) const {
  switch (step) {
    case choose:
      return tr(
          "Welcome. Try everything on the simulated touchpad, or connect your own. The answer is remembered and can "
          "be changed in Devices.");
    case connected: return tr("Choose the touchpad and its camera in Devices, then press Connect there.");
    case calibrate:
      return tr(
          "The touchpad answers. Calibrate its parts, so that what it shows can be trusted; motors move only while "
          "you hold a button.");
    case touch:
      return context_.session.simulated()
                 ? tr("Go to Operate, hold Arm in the bar above until it acts, then press the cloth: with the mouse on "
                      "the "
                      "camera's picture.")
                 : tr("Go to Operate, hold Arm in the bar above until it acts, then press the cloth with a finger. Esc "
                      "stops at any time.");
    case over:
      return tr("That was the first touch. Esc or STOP switches the motors off; the manual (F1) explains the rest.");
  }
  return {};
}

std::vector<widgets::GuideStrip::Action> FirstSteps::actions(Step step) {
  const widgets::GuideStrip::Action own{QStringLiteral("first_own"), tr("Mine …"), [this] { emit ownAsked(); }};
  switch (step) {
    case choose: return {{QStringLiteral("first_simulated"), tr("Simulated"), [this] { chooseSimulated(); }}, own};
    case connected: return {{QStringLiteral("first_connect"), tr("Devices"), [this] { emit ownAsked(); }}};
    case calibrate:
      return {{QStringLiteral("first_calibrate"), tr("Calibrate"), [this] { go_(QStringLiteral("calibrate")); }},
              {QStringLiteral("first_later"), tr("Later"), [this] {
                 calibrates_later_ = true;
                 refresh();
               }}};
    case touch: return {{QStringLiteral("first_operate"), tr("Operate"), [this] { go_(QStringLiteral("operate")); }}};
    case over: return {};
  }
  return {};
}

}  // namespace fyd::console
