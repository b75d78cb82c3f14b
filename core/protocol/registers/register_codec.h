// Blocks of the register map as structs. Pure, no allocation; a decoder takes any registers and says what is wrong.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/base/batch.h"
#include "core/base/message.h"
#include "core/control/motor_types.h"
#include "core/protocol/registers/register_map.h"

namespace fyd::protocol {

inline constexpr std::size_t kMapIrSensors = 3;

struct DeviceIdentity {
  std::uint32_t magic = kMapMagic;
  std::uint16_t map_version = kMapVersion;
  std::uint16_t firmware = 0;
  std::array<char, 16> serial{};
  std::uint16_t ir_sensors = kMapIrSensors;
  std::uint16_t motors = control::kMotorCount;
  std::uint16_t vibration_capacity = kVibrationBatch;

  void setSerial(std::string_view text);  ///< cut to 16 characters
  /// Up to the first character that is not printable ASCII.
  [[nodiscard]] std::string_view serialText() const;
};
using IdentityRegisters = std::array<std::uint16_t, kIdentityRegisters>;
[[nodiscard]] IdentityRegisters encode(const DeviceIdentity& identity);
[[nodiscard]] DeviceIdentity decodeIdentity(const IdentityRegisters& registers);

/// What the device says in every cycle.
struct DeviceState {
  std::uint16_t sequence = 0;
  std::uint16_t nonce_echo = 0;
  std::uint32_t uptime_us = 0;
  std::uint16_t status_word = 0;
  std::uint16_t fault_code = 0;
  float bridge_mV_per_V = 0.0F;  ///< NaN: does not measure
  double bridge_age_ms = 0.0;
  std::uint16_t bridge_count = 0;
  std::array<std::uint16_t, kMapIrSensors> ir{};
  double ir_age_ms = 0.0;
  std::uint16_t ir_count = 0;
  control::MotorFeedback motors;
  std::array<double, control::kMotorCount> temperature_degC{};
  std::uint16_t vibration_waiting = 0;
  std::uint16_t vibration_lost = 0;
};
using StateRegisters = std::array<std::uint16_t, kStateRegisters>;
[[nodiscard]] StateRegisters encode(const DeviceState& state);

/// Plausible range of a motor's winding temperature: colder than any laboratory, and hotter than a winding survives.
inline constexpr double kColdestMotor_degC = -40.0;
inline constexpr double kHottestMotor_degC = 200.0;

enum class StateProblem : std::uint8_t {
  none,
  torn,
  bad_status,
  bad_ir,
  bad_encoder,
  bad_current,
  bad_duty,
  bad_temperature,
};
/// What is wrong, with the values and what was expected.
[[nodiscard]] Message describe(StateProblem problem, const DeviceState& state);
/// @param state filled whatever the problem; a duty that is not known as 0
[[nodiscard]] StateProblem decode(const StateRegisters& registers, DeviceState& state);

/// One moment's duties in whole percent.
using DutyPair = std::array<std::int8_t, control::kMotorCount>;
/// Rounded to whole percent, limited to ±100; NaN counts as 0.
[[nodiscard]] DutyPair toDutyPair(const std::array<double, control::kMotorCount>& percent);

/// What the master asks for in every cycle.
struct DeviceCommand {
  std::uint16_t control_word = 0;
  std::uint16_t heartbeat = 0;
  std::uint16_t nonce = 0;
  std::array<std::int16_t, control::kMotorCount> reference_ticks{};
  std::uint16_t vibration_rate_Hz = 1000;
  std::uint16_t vibration_batch = 0;
  Batch<DutyPair, kVibrationBatch> duties;
};
using CommandRegisters = std::array<std::uint16_t, kCommandRegisters>;
/// @return how many registers are to be written: the head and one for each duty
std::size_t encode(const DeviceCommand& command, CommandRegisters& registers);
/// @return false when rate or count are out of range or fewer registers than the count says were given
[[nodiscard]] bool decode(std::span<const std::uint16_t> registers, DeviceCommand& command);

/// High word first.
[[nodiscard]] constexpr std::array<std::uint16_t, 2> split(std::uint32_t value) {
  return {static_cast<std::uint16_t>(value >> 16U), static_cast<std::uint16_t>(value)};
}
[[nodiscard]] constexpr std::uint32_t join(std::uint16_t high, std::uint16_t low) {
  return (std::uint32_t{high} << 16U) | low;
}

}  // namespace fyd::protocol
