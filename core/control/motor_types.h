// What is written to the two motors and what they report.
#pragma once

#include <array>
#include <cstdint>

namespace fyd::control {

inline constexpr std::size_t kMotorCount = 2;

/// Motor references are in ticks, 4200 for 90° (thesis §4.1.4, ANGLE_SF); a tick is not an encoder count.
inline constexpr double kTicksPerDegree = 4200.0 / 90.0;
/// AS5045, 12 bit absolute: 0 to one less than this.
inline constexpr int kEncoderCountsPerTurn = 4096;
inline constexpr double kEncoderCountsPerDegree = kEncoderCountsPerTurn / 360.0;

/// No board for motors of this size (1.5 A at standstill) carries more: a larger reading is not a current.
inline constexpr double kLargestCurrent_mA = 10'000.0;

/// Turning in opposite senses stretches the cloth, in the same sense moves it sideways.
struct MotorCommand {
  std::array<std::int16_t, kMotorCount> reference_ticks{};
  std::array<double, kMotorCount> vibration_duty_percent{};  ///< −100…100, added to the position loop's own duty
  bool active = false;                                       ///< false: motors de-energised

  friend bool operator==(const MotorCommand&, const MotorCommand&) = default;
};

struct MotorFeedback {
  std::array<std::uint16_t, kMotorCount> encoder_counts{};  ///< 0…4095
  std::array<double, kMotorCount> current_mA{};             ///< signed
  std::array<double, kMotorCount> position_duty_percent{};  ///< share the board's position loop uses; see known flag
  bool position_duty_known = false;                         ///< false when the board closes its own loop unseen
};

}  // namespace fyd::control
