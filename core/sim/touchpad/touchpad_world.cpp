#include "core/sim/touchpad/touchpad_world.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/sim/touchpad/ir_sensor.h"

namespace fyd::sim {
namespace {

constexpr double kBridgeSpan_mV_per_V = 7.77;  // at gain 128 [PhidgetBridge]

/// Inverse of F = (1004.8805·value − 20.2512)/1000·g [thesis §4.1.3].
double bridgeValue(double force_N) { return (force_N / kStandardGravity * 1000.0 + 20.2512) / 1004.8805; }

std::uint16_t encoderCounts(double angle_deg) {
  const long counts = std::lround(angle_deg * control::kEncoderCountsPerDegree);
  return static_cast<std::uint16_t>(static_cast<unsigned long>(counts) & 0xFFFU);
}

/// Keeps a sensor on its own period independent of the grid, and skips samples that a jump of time left out.
void scheduleNext(Instant& next, Instant now, Duration period) {
  next += period;
  if (next <= now) next = now + period;
}

double clean(double value, double low, double high) {
  return std::isfinite(value) ? std::clamp(value, low, high) : 0.0;
}

FingerState cleaned(const FingerState& finger) {
  const bool lifted =
      finger.lifted || !std::isfinite(finger.x_mm) || !std::isfinite(finger.y_mm) || !(finger.indentation_mm > 0.0);
  return {.x_mm = clean(finger.x_mm, -kUsableHalfWidth_mm, kUsableHalfWidth_mm),
          .y_mm = clean(finger.y_mm, -kUsableHalfDepth_mm, kUsableHalfDepth_mm),
          .indentation_mm = lifted ? 0.0 : std::min(finger.indentation_mm, kDeepestPress_mm),
          .lifted = lifted};
}

double mix(double a, double b, double share) { return a + (b - a) * share; }

WorldSnapshot between(const WorldSnapshot& a, const WorldSnapshot& b, Instant when) {
  const double share = toSeconds(when - a.taken) / toSeconds(b.taken - a.taken);
  WorldSnapshot out = share < 1.0 ? a : b;  // for members that cannot be interpolated
  out.taken = when;
  out.angle_deg = mix(a.angle_deg, b.angle_deg, share);
  out.felt_g = mix(a.felt_g, b.felt_g, share);
  out.stiffness_N_per_mm = mix(a.stiffness_N_per_mm, b.stiffness_N_per_mm, share);
  for (std::size_t i = 0; i < out.motor_deg.size(); ++i) out.motor_deg[i] = mix(a.motor_deg[i], b.motor_deg[i], share);
  if (a.finger.lifted == b.finger.lifted) {
    out.finger.x_mm = mix(a.finger.x_mm, b.finger.x_mm, share);
    out.finger.y_mm = mix(a.finger.y_mm, b.finger.y_mm, share);
    out.finger.indentation_mm = mix(a.finger.indentation_mm, b.finger.indentation_mm, share);
    out.force_N = mix(a.force_N, b.force_N, share);
    out.contact_area_mm2 = mix(a.contact_area_mm2, b.contact_area_mm2, share);
    out.contact_x_mm = mix(a.contact_x_mm, b.contact_x_mm, share);
    out.contact_y_mm = mix(a.contact_y_mm, b.contact_y_mm, share);
  }
  return out;
}

}  // namespace

TouchpadWorld::TouchpadWorld(const SimParameters& parameters, FingerPath path, Instant start)
    : parameters_(parameters),
      path_(std::move(path)),
      path_begins_(start),
      cloth_(parameters),
      vibration_(parameters.vibration, parameters.initial_angle_deg),
      motors_{SimulatedMotor(parameters.initial_angle_deg), SimulatedMotor(-parameters.initial_angle_deg)},
      random_(static_cast<std::uint64_t>(parameters.seed)),
      now_(start),
      pressed_(start),
      next_ir_(start),
      next_bridge_(start),
      history_(static_cast<std::size_t>(kHistory / kStep)) {
  remember();
  sense();
}

void TouchpadWorld::advanceTo(Instant now) {
  const std::scoped_lock lock(mutex_);
  if (now <= now_) return;
  if (now - now_ > kLongestCatchUp) skip(now - now_ - kLongestCatchUp);
  while (now - now_ >= kStep) step();
}

void TouchpadWorld::skip(Duration gap) { now_ += (gap + kStep - Duration(1)) / kStep * kStep; }

void TouchpadWorld::step() {
  now_ += kStep;
  const MotorLimits limits{.speed_deg_s = parameters_.motor_speed_limit_deg_s,
                           .current_mA = parameters_.motor_current_limit_mA,
                           .friction_percent = parameters_.motor_friction_percent};
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    motors_[i].step(command_.reference_ticks[i] / control::kTicksPerDegree, command_.vibration_duty_percent[i],
                    command_.active, limits, toSeconds(kStep));
  }
  const double stretch_ticks = 0.5 * (command_.reference_ticks[0] - command_.reference_ticks[1]);
  if (command_.active) vibration_.setStretch(stretch_ticks / control::kTicksPerDegree);
  vibration_g_ =
      vibration_.step(command_.active ? command_.vibration_duty_percent : decltype(command_.vibration_duty_percent){},
                      truthLocked(now_).force_N);
  remember();
  sense();
}

FingerState TouchpadWorld::fingerNow() const {
  return cleaned(finger_override_ ? *finger_override_ : path_.at(toSeconds(now_ - path_begins_)));
}

void TouchpadWorld::remember() {
  WorldSnapshot& present = history_[written_ % history_.size()];
  ++written_;
  present.taken = now_;
  present.finger = fingerNow();
  for (std::size_t i = 0; i < motors_.size(); ++i) present.motor_deg[i] = motors_[i].angle_deg();
  present.angle_deg = 0.5 * (present.motor_deg[0] - present.motor_deg[1]);
  present.stiffness_N_per_mm = cloth_.stiffness(present.angle_deg, present.finger);
  const Pressing pressing = cloth_.press(present.angle_deg, present.finger, toSeconds(now_ - pressed_));
  pressed_ = now_;
  present.force_N = pressing.force_N;
  present.contact_area_mm2 = pressing.area_mm2;
  present.contact_x_mm = present.finger.x_mm + pressing.centre_x_mm;
  present.contact_y_mm = present.finger.y_mm + pressing.centre_y_mm;
  present.felt_g = present.finger.lifted ? 0.0 : vibration_g_;
}

void TouchpadWorld::sense() {
  senseMotors();
  if (now_ >= next_ir_) senseIr();
  if (now_ >= next_bridge_) senseBridge();
}

WorldSnapshot TouchpadWorld::lookBack(double delay_ms) const {
  return truthLocked(now_ - fromSeconds(delay_ms / 1000.0));
}

void TouchpadWorld::senseIr() {
  scheduleNext(next_ir_, now_, fromSeconds(parameters_.ir_period_ms / 1000.0));
  const FingerState finger = lookBack(parameters_.ir_delay_ms).finger;
  sensing::IrCounts counts;
  for (const SensorPlace& place : kIrPlaces) {
    const double sunk_mm = cloth_.deflection_mm(place.x_mm, place.y_mm, finger);
    const double volts = irVolts(parameters_.cloth_height_mm - sunk_mm) + gaussian(parameters_.ir_noise_mV / 1000.0);
    static_cast<void>(counts.push(irCode(volts)));
  }
  readings_.ir.set(counts, now_);
}

void TouchpadWorld::senseBridge() {
  scheduleNext(next_bridge_, now_, fromSeconds(1.0 / parameters_.bridge_rate_Hz));
  const double value = bridgeValue(lookBack(parameters_.bridge_delay_ms).force_N) + parameters_.bridge_offset_mV_per_V +
                       gaussian(parameters_.bridge_noise_mV_per_V);
  readings_.bridge.set({.value_mV_per_V = std::clamp(value, -kBridgeSpan_mV_per_V, kBridgeSpan_mV_per_V)}, now_);
}

void TouchpadWorld::senseMotors() {
  const WorldSnapshot seen = lookBack(parameters_.encoder_delay_ms);
  control::MotorFeedback feedback;
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    feedback.encoder_counts[i] = encoderCounts(seen.motor_deg[i]);
    feedback.current_mA[i] = motors_[i].current_mA();
    if (parameters_.reports_position_duty) feedback.position_duty_percent[i] = motors_[i].positionDuty_percent();
  }
  feedback.position_duty_known = parameters_.reports_position_duty;
  readings_.motors.set(feedback, now_);
}

double TouchpadWorld::gaussian(double sigma) { return sigma * normal_(random_); }

void TouchpadWorld::command(const control::MotorCommand& command) {
  const std::scoped_lock lock(mutex_);
  command_ = command;
}

device::TouchpadReadings TouchpadWorld::readings() const {
  const std::scoped_lock lock(mutex_);
  return readings_;
}

WorldSnapshot TouchpadWorld::truthAt(Instant when) const {
  const std::scoped_lock lock(mutex_);
  return truthLocked(when);
}

WorldSnapshot TouchpadWorld::truth() const {
  const std::scoped_lock lock(mutex_);
  return truthLocked(now_);
}

WorldSnapshot TouchpadWorld::truthLocked(Instant when) const {
  const std::size_t kept = std::min(written_, history_.size());
  const auto entry = [&](std::size_t n) -> const WorldSnapshot& { return history_[n % history_.size()]; };
  std::size_t low = written_ - kept;  // oldest
  std::size_t high = written_ - 1;    // newest
  if (when >= entry(high).taken) return entry(high);
  if (when <= entry(low).taken) return entry(low);
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (entry(middle).taken <= when ? low : high) = middle;
  }
  return between(entry(low), entry(high), when);
}

void TouchpadWorld::setFingerOverride(std::optional<FingerState> finger) {
  const std::scoped_lock lock(mutex_);
  finger_override_ = finger;
}

void TouchpadWorld::setPath(FingerPath path) {
  const std::scoped_lock lock(mutex_);
  std::swap(path_, path);  // the former path is freed after unlocking, so that the step does not wait for it
  path_begins_ = now_;
}

}  // namespace fyd::sim
