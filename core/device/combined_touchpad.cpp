#include "core/device/combined_touchpad.h"

namespace fyd::device {
namespace {

constexpr Duration kRetry = std::chrono::milliseconds(200);  // so that a dead half does not slow the other down
constexpr int kFailuresUntilRest = 3;

}  // namespace

std::string CombinedTouchpad::description() const {
  return fmt::format("{}; {}", sensors_->description(), motors_->description());
}

void CombinedTouchpad::askSensors(Instant now) {
  if (now < sensors_due_) return;
  const auto sensed = sensors_->exchange({}, now);
  sensor_problem_ = sensed ? sensors_->complaint() : sensed.error().message;
  sensors_due_ = now + (sensed ? sensors_->period() : kRetry);
  if (!sensed) return;
  readings_.ir = sensed->ir;
  readings_.bridge = sensed->bridge;
}

void CombinedTouchpad::askMotors(const control::MotorCommand& command, Instant now) {
  if (now < motors_due_) return;
  const auto moved = motors_->exchange(command);
  motor_problem_ = moved ? std::string() : moved.error().message;
  motor_failures_ = moved ? 0 : motor_failures_ + 1;
  motors_due_ = motor_failures_ < kFailuresUntilRest ? now : now + kRetry;
  if (moved) readings_.motors.set(*moved, now);
}

Result<TouchpadReadings> CombinedTouchpad::exchange(const control::MotorCommand& command, Instant now) {
  askMotors(command, now);
  askSensors(now);
  if (!sensor_problem_.empty() && !motor_problem_.empty()) return fail("{}; {}", sensor_problem_, motor_problem_);
  return readings_;
}

std::string CombinedTouchpad::complaint() const { return sensor_problem_.empty() ? motor_problem_ : sensor_problem_; }

}  // namespace fyd::device
