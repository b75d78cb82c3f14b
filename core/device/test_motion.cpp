#include "core/device/test_motion.h"

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

double motionLength_s(DeviceTest test) { return test == DeviceTest::vibration ? kVibration_s : kMotion_s; }

}  // namespace

Result<TestMotion> TestMotion::plan(DeviceTest test, const std::array<double, control::kMotorCount>& motor_deg,
                                    double motor_limit_deg) {
  if (static_cast<std::size_t>(test) >= kDeviceTestNames.size()) {
    return fail("device test {}: there is none of this number", static_cast<int>(test));
  }
  for (std::size_t i = 0; i < motor_deg.size(); ++i) {
    if (std::abs(motor_deg[i]) <= motor_limit_deg) continue;  // false for NaN
    return fail("motor {} stands at {:.1f}°, beyond control.motor_limit_deg = {:.0f}: check the encoder's zero", i + 1,
                motor_deg[i], motor_limit_deg);
  }
  TestMotion out;
  out.test_ = test;
  out.rest_deg_ = motor_deg;
  if (test != DeviceTest::vibration) {
    const double rest = motor_deg[static_cast<std::size_t>(test)];
    out.travel_deg_ = rest + kTestTravel_deg <= motor_limit_deg ? kTestTravel_deg : -kTestTravel_deg;
  }
  return out;
}

Duration TestMotion::length() const { return fromSeconds(kRestBefore_s + motionLength_s(test_) + kRestAfter_s); }

std::array<double, control::kMotorCount> TestMotion::anglesAt(Duration since_start) const {
  std::array<double, control::kMotorCount> out = rest_deg_;
  const double t = std::clamp(toSeconds(since_start) - kRestBefore_s, 0.0, motionLength_s(test_));
  if (test_ != DeviceTest::vibration) {
    out[static_cast<std::size_t>(test_)] +=
        travel_deg_ * 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * t / kMotion_s));
  }
  return out;
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
  return out;
}

}  // namespace fyd::device
