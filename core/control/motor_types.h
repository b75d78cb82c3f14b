// What is written to the two motors and what they report.
// Stability: stable since 0.1
#pragma once

#include <array>
#include <cstdint>

#include "core/base/fields.h"

namespace fyd::control {

inline constexpr std::size_t kMotorCount = 2;

/// Motor references are in ticks, 4200 for 90° (ANGLE_SF [thesis §4.1.4]); a tick is not an encoder count.
inline constexpr double kTicksPerDegree = 4200.0 / 90.0;
/// AS5045, 12 bit absolute: 0 to one less than this.
inline constexpr int kEncoderCountsPerTurn = 4096;
inline constexpr double kEncoderCountsPerDegree = kEncoderCountsPerTurn / 360.0;

/// A larger reading is not a current: no board for motors of this size (1.5 A at standstill) carries more.
inline constexpr double kLargestCurrent_mA = 10'000.0;

/// Turning in opposite senses stretches the cloth, in the same sense moves it sideways.
struct MotorCommand {
  std::array<std::int16_t, kMotorCount> reference_ticks{};
  std::array<double, kMotorCount> vibration_duty_percent{};
  bool active = false;

  static constexpr auto fields() {
    using M = MotorCommand;
    return std::tuple(
        Field("vibration_duty_percent", "%", "−100 to 100 for each motor, added to the position loop's own duty",
              &M::vibration_duty_percent),
        Field("reference_ticks", "tick", "where each motor is to turn", &M::reference_ticks),
        Field("active", "1", "0: the motors are de-energised", &M::active));
  }
  friend bool operator==(const MotorCommand&, const MotorCommand&) = default;
};

struct MotorFeedback {
  std::array<std::uint16_t, kMotorCount> encoder_counts{};
  std::array<double, kMotorCount> current_mA{};
  std::array<double, kMotorCount> position_duty_percent{};
  bool position_duty_known = false;

  static constexpr auto fields() {
    using M = MotorFeedback;
    return std::tuple(
        Field("current_mA", "mA", "of each motor, signed", &M::current_mA),
        Field("position_duty_percent", "%", "share of each motor's drive that the board's position loop uses",
              &M::position_duty_percent),
        Field("encoder_counts", "count", "of each motor, 0 to 4095", &M::encoder_counts),
        Field("position_duty_known", "1", "0: the board closes its own loop unseen", &M::position_duty_known));
  }
};

}  // namespace fyd::control
