#include "core/device/touchpad/combined_touchpad.h"

namespace fyd::device {
namespace {

constexpr Duration kRetry = std::chrono::milliseconds(200);
constexpr int kFailuresUntilRest = 3;
constexpr Duration kReportPeriod = std::chrono::milliseconds(100);
constexpr Duration kVibrationTimeout = std::chrono::milliseconds(20);

}  // namespace

bool CombinedTouchpad::Half::reportDue(Instant now) {
  if (now < report_due_) return false;
  report_due_ = now + kReportPeriod;
  return true;
}

void CombinedTouchpad::Half::publish(DeviceReport report) {
  const std::lock_guard lock(mutex_);
  report_ = std::move(report);
}

void CombinedTouchpad::Half::remember(Message why_switched_off) {
  const std::lock_guard lock(mutex_);
  why_switched_off_ = std::move(why_switched_off);
}

Message CombinedTouchpad::Half::whySwitchedOff() const {
  const std::lock_guard lock(mutex_);
  return why_switched_off_;
}

Message CombinedTouchpad::Half::description(const Message& fallback) const {
  const std::lock_guard lock(mutex_);
  return report_.description.empty() ? fallback : report_.description;
}

DeviceReport CombinedTouchpad::Half::report(Instant now) const {
  DeviceReport out;
  {
    const std::lock_guard lock(mutex_);
    out = report_;
  }
  monitor.fillIn(out, now);
  return out;
}

CombinedTouchpad::CombinedTouchpad(std::unique_ptr<Touchpad> sensors, std::unique_ptr<QbmoveMotors> motors,
                                   const DeviceParameters& parameters)
    : sensors_(std::move(sensors)),
      motors_(std::move(motors)),
      names_(listed({sensors_->description(), motors_->description()})),
      longest_silence_(fromSeconds(parameters.qbmove_watchdog_ms / 1e3)) {
  auto known = sensors_->reports();
  if (!known.empty()) sensor_half_.publish(std::move(known.front()));
  motor_half_.publish(motors_->report());
}

CombinedTouchpad::~CombinedTouchpad() {
  sensor_thread_.request_stop();
  motor_thread_.request_stop();
}

Message CombinedTouchpad::description() const {
  return listed({sensor_half_.description(names_), motor_half_.description({})});
}

// If the caller has not renewed the command in time, the vibration duty becomes 0, and after longest_silence_ the motors
// go off. An inactive command in its place would undo the board's refusal, and the next active one, which is not the
// operator's, would switch the motors on.
Result<control::MotorFeedback> CombinedTouchpad::exchangeWithMotors(Instant now) {
  const Given& given = command_.read();
  control::MotorCommand command = given.command;
  if (now - given.when > kVibrationTimeout) command.vibration_duty_percent = {};
  return motors_->exchange(command, now - given.when <= longest_silence_);
}

void CombinedTouchpad::runSensors(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    const Instant now = Clock::now();
    const auto sensed = sensors_->exchange({}, now);
    if (sensed) {
      sensed_.write(*sensed);
      sensor_half_.monitor.succeeded(now, sensors_->complaint());
    } else {
      sensor_half_.monitor.failed(sensed.error().message);
    }
    sensor_half_.failing = !sensed;
    if (sensor_half_.reportDue(now)) {
      auto reports = sensors_->reports();
      if (!reports.empty()) sensor_half_.publish(std::move(reports.front()));
    }
    std::this_thread::sleep_until(sensed ? now + sensors_->period() : Clock::now() + kRetry);
  }
}

void CombinedTouchpad::runMotors(const std::stop_token& stop) {
  Timed<control::MotorFeedback> newest;
  int failures = 0;  // in a row
  while (!stop.stop_requested()) {
    const Instant now = Clock::now();
    const auto moved = exchangeWithMotors(now);
    if (moved) {
      newest.set(*moved, now);
      moved_.write(newest);
      motor_half_.monitor.succeeded(now);
    } else {
      motor_half_.monitor.failed(moved.error().message);
    }
    motor_half_.failing = !moved;
    motor_half_.remember(motors_->whySwitchedOff());
    failures = moved ? 0 : failures + 1;
    if (motor_half_.reportDue(now)) motor_half_.publish(motors_->report());
    std::this_thread::sleep_until(failures < kFailuresUntilRest ? now + period() : Clock::now() + kRetry);
  }
  for (int i = 0; i < kFarewells && !motors_->exchange({}); ++i) continue;  // until the board says that they are off
}

Result<TouchpadReadings> CombinedTouchpad::exchange(const control::MotorCommand& command, Instant now) {
  command_.write({.command = command, .when = now});
  if (!motor_thread_.joinable()) {
    sensor_thread_ = std::jthread([this](const std::stop_token& stop) { runSensors(stop); });
    motor_thread_ = std::jthread([this](const std::stop_token& stop) { runMotors(stop); });
  }
  const TouchpadReadings& sensed = sensed_.read();
  readings_.ir = sensed.ir;
  readings_.bridge = sensed.bridge;
  readings_.motors = moved_.read();
  if (!sensor_half_.failing || !motor_half_.failing) return readings_;
  return fail(listed({sensor_half_.monitor.problem(now), motor_half_.monitor.problem(now)}));
}

Message CombinedTouchpad::complaint() const {
  const Instant now = Clock::now();
  const Message sensors = sensor_half_.monitor.problem(now);
  return sensors.empty() ? motor_half_.monitor.problem(now) : sensors;
}

Message CombinedTouchpad::whySwitchedOff() const { return motor_half_.whySwitchedOff(); }

std::vector<DeviceReport> CombinedTouchpad::reports() const {
  const Instant now = Clock::now();
  return {sensor_half_.report(now), motor_half_.report(now)};
}

}  // namespace fyd::device
