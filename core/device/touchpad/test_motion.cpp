#include "core/device/touchpad/test_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/control/motor_mixing.h"

namespace fyd::device {
namespace {

constexpr double kRestBefore_s = 0.3;  // a drive needs a few cycles to switch on
constexpr double kRestAfter_s = 0.2;
constexpr double kMotion_s = 4.0;
constexpr double kVibration_s = 0.5;
constexpr double kVibrationRamp_s = 0.1;
constexpr double kVibration_Hz = 150.0;

constexpr double kStretchSpeed_deg_s = 10.0;  // on average; π/2 times that at most
constexpr double kStretchLeast_s = 0.5;
constexpr double kStretchHold_s = 60.0;
constexpr double kSweepLevel_s = 1.2;
constexpr double kSweepMove_s = 0.4;
constexpr double kSettled_s = 0.3;

constexpr double kRamp_s = kRampTop_percent / kRampSpeed_percent_s;
constexpr double kRampPause_s = 0.5;
constexpr int kRamps = 2 * static_cast<int>(control::kMotorCount);

constexpr double kChirpSettle_s = 0.5;
constexpr double kChirpFadeIn_s = 0.1;
constexpr double kChirpDuty_percent = 90.0;
constexpr double kChirpFrom_Hz = 8.0;
constexpr double kChirpTo_Hz = 350.0;

double chirpDuty_percent(double t) {
  const double turns = kChirpFrom_Hz * t + (kChirpTo_Hz - kChirpFrom_Hz) * t * t / (2.0 * kChirp_s);
  return kChirpDuty_percent * std::min(1.0, t / kChirpFadeIn_s) * std::sin(2.0 * std::numbers::pi * turns);
}

/// From 0 to 1 with zero speed at both ends.
double eased(double share) { return 0.5 * (1.0 - std::cos(std::numbers::pi * std::clamp(share, 0.0, 1.0))); }

/// Stretch of a level of the sweep: 0, 5, … 30, … 5, 0.
double sweepLevel_deg(double level) {
  constexpr double kTop = kSweepTop_deg / kSweepStep_deg;
  return kSweepStep_deg * std::max(0.0, kTop - std::abs(level - kTop));
}

constexpr double kSweepLevels = 2.0 * kSweepTop_deg / kSweepStep_deg + 1.0;

}  // namespace

Result<TestMotion> TestMotion::plan(DeviceTest test, const std::array<double, control::kMotorCount>& motor_deg,
                                    double motor_limit_deg, double stretch_deg) {
  if (static_cast<std::size_t>(test) >= kDeviceTestNames.size()) {
    return fail("device test {}: no test has this number", static_cast<int>(test));
  }
  TestMotion out;
  out.test_ = test;
  out.rest_deg_ = motor_deg;
  const auto beyond = [&](double deg) {
    return fail("stretch {:g}°: beyond control.motor_limit_deg = {:.0f}", deg, motor_limit_deg);
  };
  if (test == DeviceTest::sweep) {
    if (!(kSweepTop_deg <= motor_limit_deg)) return beyond(kSweepTop_deg);
    out.rest_deg_ = {};
    out.length_s_ = kSweepLevels * kSweepLevel_s;
    return out;
  }
  for (std::size_t i = 0; i < motor_deg.size(); ++i) {
    if (std::abs(motor_deg[i]) <= motor_limit_deg) continue;  // false for NaN
    return fail("motor {} stands at {:.1f}°, beyond control.motor_limit_deg = {:.0f}: check the encoder's zero", i + 1,
                motor_deg[i], motor_limit_deg);
  }
  if (test == DeviceTest::breakaway) {
    out.length_s_ = kRamps * (kRamp_s + kRampPause_s);
    return out;
  }
  if (goesToStretch(test)) {
    if (!(std::abs(stretch_deg) <= motor_limit_deg)) return beyond(stretch_deg);
    out.stretch_deg_ = stretch_deg;
    const double way = std::max(std::abs(stretch_deg - motor_deg[0]), std::abs(stretch_deg + motor_deg[1]));
    out.travel_s_ = std::max(kStretchLeast_s, way / kStretchSpeed_deg_s);
    out.length_s_ = out.travel_s_ + (test == DeviceTest::chirp ? kChirpSettle_s + kChirp_s : kStretchHold_s);
    return out;
  }
  out.length_s_ = test == DeviceTest::vibration ? kVibration_s : kMotion_s;
  if (test != DeviceTest::vibration) {
    const double rest = motor_deg[static_cast<std::size_t>(test)];
    out.travel_deg_ = rest + kTestTravel_deg <= motor_limit_deg ? kTestTravel_deg : -kTestTravel_deg;
  }
  return out;
}

Duration TestMotion::length() const { return fromSeconds(kRestBefore_s + length_s_ + kRestAfter_s); }

std::array<double, control::kMotorCount> TestMotion::anglesAt(Duration since_start) const {
  std::array<double, control::kMotorCount> out = rest_deg_;
  const double t = std::clamp(toSeconds(since_start) - kRestBefore_s, 0.0, length_s_);
  if (test_ == DeviceTest::vibration || test_ == DeviceTest::breakaway) return out;
  if (test_ == DeviceTest::sweep) {
    const double level = std::floor(t / kSweepLevel_s);
    const double share = eased((t - level * kSweepLevel_s) / kSweepMove_s);
    const double before = sweepLevel_deg(level - 1.0);
    const double stretch = before + (sweepLevel_deg(level) - before) * share;
    return {stretch, -stretch};
  }
  if (goesToStretch(test_)) {
    const double share = eased(t / travel_s_);
    return {out[0] + (stretch_deg_ - out[0]) * share, out[1] + (-stretch_deg_ - out[1]) * share};
  }
  out[static_cast<std::size_t>(test_)] += travel_deg_ * 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * t / kMotion_s));
  return out;
}

bool TestMotion::restsAt(Duration since_start) const {
  return since_start >= fromSeconds(kRestBefore_s + kSettled_s) &&
         anglesAt(since_start) == anglesAt(since_start - fromSeconds(kSettled_s));
}

std::optional<control::MotorCommand> TestMotion::at(Duration since_start) const {
  if (since_start < Duration::zero() || since_start >= length()) return std::nullopt;
  control::MotorCommand out{.active = true};
  const auto angles = anglesAt(since_start);
  for (std::size_t i = 0; i < angles.size(); ++i) out.reference_ticks[i] = control::ticksFromDegrees(angles[i]);
  const double t = toSeconds(since_start) - kRestBefore_s;
  if (test_ == DeviceTest::vibration && t > 0.0 && t < kVibration_s) {
    const double envelope = std::min({1.0, t / kVibrationRamp_s, (kVibration_s - t) / kVibrationRamp_s});
    out.vibration_duty_percent.fill(kTestDuty_percent * envelope *
                                    std::sin(2.0 * std::numbers::pi * kVibration_Hz * t));
  }
  const int experiment = experimentAt(since_start);
  if (test_ == DeviceTest::breakaway && experiment > 0) {
    const int ramp = experiment - 1;
    const double duty = kRampSpeed_percent_s * (t - ramp * (kRamp_s + kRampPause_s));
    out.vibration_duty_percent[static_cast<std::size_t>(ramp / 2)] = ramp % 2 == 0 ? duty : -duty;
  }
  if (test_ == DeviceTest::chirp && experiment > 0) {
    out.vibration_duty_percent.fill(chirpDuty_percent(t - travel_s_ - kChirpSettle_s));
  }
  return out;
}

int TestMotion::experimentAt(Duration since_start) const {
  const double t = toSeconds(since_start) - kRestBefore_s;
  if (t < 0.0 || t >= length_s_) return 0;
  if (test_ == DeviceTest::breakaway) {
    const double ramp = std::floor(t / (kRamp_s + kRampPause_s));
    return t - ramp * (kRamp_s + kRampPause_s) < kRamp_s ? static_cast<int>(ramp) + 1 : 0;
  }
  return test_ == DeviceTest::chirp && t >= travel_s_ + kChirpSettle_s ? 1 : 0;
}

}  // namespace fyd::device
