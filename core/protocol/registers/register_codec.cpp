#include "core/protocol/registers/register_codec.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "core/protocol/registers/drive_state.h"

namespace fyd::protocol {
namespace {

constexpr std::int16_t kDutyUnknown = -32768;
constexpr std::uint16_t kLargestCode = 4095;  // 12 bit, ADC and encoder
constexpr std::uint16_t kLargestRate_Hz = 2000;

/// value / step, rounded and saturated; NaN gives 0.
template <class Integer>
std::uint16_t quantised(double value, double step) {
  if (std::isnan(value)) return 0;
  const double steps = std::clamp(std::round(value / step), static_cast<double>(std::numeric_limits<Integer>::min()),
                                  static_cast<double>(std::numeric_limits<Integer>::max()));
  return static_cast<std::uint16_t>(static_cast<Integer>(steps));
}

std::int16_t signedOf(std::uint16_t value) { return static_cast<std::int16_t>(value); }

template <class Registers>
void put32(Registers& registers, std::size_t at, std::uint32_t value) {
  const auto words = split(value);
  registers[at] = words[0];
  registers[at + 1] = words[1];
}

consteval std::size_t state(std::string_view name) { return addressOf(name) - kStateAddress; }
consteval std::size_t command(std::string_view name) { return addressOf(name) - kCommandAddress; }
consteval std::size_t identity(std::string_view name) { return addressOf(name) - kIdentityAddress; }

}  // namespace

void DeviceIdentity::setSerial(std::string_view text) {
  serial = {};
  std::ranges::copy(text.substr(0, serial.size()), serial.begin());
}

std::string_view DeviceIdentity::serialText() const {
  const auto end = std::ranges::find_if(serial, [](char c) { return c < ' ' || c > '~'; });
  return {serial.data(), static_cast<std::size_t>(end - serial.begin())};
}

IdentityRegisters encode(const DeviceIdentity& from) {
  IdentityRegisters out{};
  put32(out, identity("magic"), from.magic);
  out[identity("map_version")] = from.map_version;
  out[identity("firmware")] = from.firmware;
  for (std::size_t i = 0; i < from.serial.size(); i += 2) {
    out[identity("serial") + i / 2] = static_cast<std::uint16_t>((static_cast<unsigned char>(from.serial[i]) << 8U) |
                                                                 static_cast<unsigned char>(from.serial[i + 1]));
  }
  out[identity("ir_sensors")] = from.ir_sensors;
  out[identity("motors")] = from.motors;
  out[identity("vibration_capacity")] = from.vibration_capacity;
  return out;
}

DeviceIdentity decodeIdentity(const IdentityRegisters& in) {
  DeviceIdentity out;
  out.magic = join(in[identity("magic")], in[identity("magic") + 1]);
  out.map_version = in[identity("map_version")];
  out.firmware = in[identity("firmware")];
  for (std::size_t i = 0; i < out.serial.size(); i += 2) {
    const std::uint16_t two = in[identity("serial") + i / 2];
    out.serial[i] = static_cast<char>(two >> 8U);
    out.serial[i + 1] = static_cast<char>(two & 0xFFU);
  }
  out.ir_sensors = in[identity("ir_sensors")];
  out.motors = in[identity("motors")];
  out.vibration_capacity = in[identity("vibration_capacity")];
  return out;
}

StateRegisters encode(const DeviceState& from) {
  StateRegisters out{};
  out[state("sequence_begin")] = from.sequence;
  out[state("nonce_echo")] = from.nonce_echo;
  put32(out, state("uptime"), from.uptime_us);
  out[state("status_word")] = from.status_word;
  out[state("fault_code")] = from.fault_code;
  put32(out, state("bridge"), std::bit_cast<std::uint32_t>(from.bridge_mV_per_V));
  out[state("bridge_age")] = quantised<std::uint16_t>(from.bridge_age_ms, 0.1);
  out[state("bridge_count")] = from.bridge_count;
  std::ranges::copy(from.ir, out.begin() + state("ir_1"));
  out[state("ir_age")] = quantised<std::uint16_t>(from.ir_age_ms, 0.1);
  out[state("ir_count")] = from.ir_count;
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    out[state("encoder_1") + i] = from.motors.encoder_counts[i];
    out[state("current_1") + i] = quantised<std::int16_t>(from.motors.current_mA[i], 1.0);
    out[state("position_duty_1") + i] = from.motors.position_duty_known
                                            ? quantised<std::int16_t>(from.motors.position_duty_percent[i], 0.01)
                                            : static_cast<std::uint16_t>(kDutyUnknown);
    out[state("temperature_1") + i] = quantised<std::int16_t>(from.temperature_degC[i], 0.1);
  }
  out[state("vibration_waiting")] = from.vibration_waiting;
  out[state("vibration_lost")] = from.vibration_lost;
  out[state("sequence_end")] = from.sequence;
  return out;
}

Message describe(StateProblem problem, const DeviceState& state) {
  const auto& motors = state.motors;
  switch (problem) {
    case StateProblem::none: return say("no problem");
    case StateProblem::torn: return say("the block changed while it was read (its two sequence numbers differ)");
    case StateProblem::bad_status: return say("the status word 0x{:04X} names no state", state.status_word);
    case StateProblem::bad_ir: return say("IR codes {}, expected 0 to {}", fmt::join(state.ir, ", "), kLargestCode);
    case StateProblem::bad_encoder:
      return say("encoder counts {}, expected 0 to {}", fmt::join(motors.encoder_counts, ", "), kLargestCode);
    case StateProblem::bad_current:
      return say("motor currents {} mA, expected -{} to {}", fmt::join(motors.current_mA, ", "),
                 control::kLargestCurrent_mA, control::kLargestCurrent_mA);
    case StateProblem::bad_duty:
      return say("position duties {} %, expected -100 to 100",
                 fmt::format("{:.2f}", fmt::join(motors.position_duty_percent, ", ")));
    case StateProblem::bad_temperature:
      return say("motor temperatures {} °C, expected {} to {}",
                 fmt::format("{:.1f}", fmt::join(state.temperature_degC, ", ")), kColdestMotor_degC,
                 kHottestMotor_degC);
  }
  return say("unknown problem");
}

StateProblem decode(const StateRegisters& in, DeviceState& out) {
  out.sequence = in[state("sequence_begin")];
  out.nonce_echo = in[state("nonce_echo")];
  out.uptime_us = join(in[state("uptime")], in[state("uptime") + 1]);
  out.status_word = in[state("status_word")];
  out.fault_code = in[state("fault_code")];
  out.bridge_mV_per_V = std::bit_cast<float>(join(in[state("bridge")], in[state("bridge") + 1]));
  out.bridge_age_ms = in[state("bridge_age")] * 0.1;
  out.bridge_count = in[state("bridge_count")];
  std::copy_n(in.begin() + state("ir_1"), out.ir.size(), out.ir.begin());
  out.ir_age_ms = in[state("ir_age")] * 0.1;
  out.ir_count = in[state("ir_count")];
  out.motors.position_duty_known = true;
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    const std::int16_t duty = signedOf(in[state("position_duty_1") + i]);
    if (duty == kDutyUnknown) out.motors.position_duty_known = false;
    out.motors.encoder_counts[i] = in[state("encoder_1") + i];
    out.motors.current_mA[i] = signedOf(in[state("current_1") + i]);
    out.motors.position_duty_percent[i] = duty == kDutyUnknown ? 0.0 : duty * 0.01;
    out.temperature_degC[i] = signedOf(in[state("temperature_1") + i]) * 0.1;
  }
  out.vibration_waiting = in[state("vibration_waiting")];
  out.vibration_lost = in[state("vibration_lost")];

  if (in[state("sequence_end")] != out.sequence) return StateProblem::torn;
  if (!driveStateOf(out.status_word)) return StateProblem::bad_status;
  const auto beyond = [](std::uint16_t code) { return code > kLargestCode; };
  if (std::ranges::any_of(out.ir, beyond)) return StateProblem::bad_ir;
  if (std::ranges::any_of(out.motors.encoder_counts, beyond)) return StateProblem::bad_encoder;
  const auto larger = [](double limit) { return [limit](double value) { return std::abs(value) > limit; }; };
  if (std::ranges::any_of(out.motors.current_mA, larger(control::kLargestCurrent_mA))) return StateProblem::bad_current;
  if (std::ranges::any_of(out.motors.position_duty_percent, larger(100.0))) return StateProblem::bad_duty;
  const auto noTemperature = [](double degC) { return degC < kColdestMotor_degC || degC > kHottestMotor_degC; };
  if (std::ranges::any_of(out.temperature_degC, noTemperature)) return StateProblem::bad_temperature;
  return StateProblem::none;
}

DutyPair toDutyPair(const std::array<double, control::kMotorCount>& percent) {
  DutyPair out{};
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!std::isnan(percent[i])) out[i] = static_cast<std::int8_t>(std::round(std::clamp(percent[i], -100.0, 100.0)));
  }
  return out;
}

std::size_t encode(const DeviceCommand& from, CommandRegisters& out) {
  out[command("control_word")] = from.control_word;
  out[command("heartbeat")] = from.heartbeat;
  out[command("nonce")] = from.nonce;
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    out[command("reference_1") + i] = static_cast<std::uint16_t>(from.reference_ticks[i]);
  }
  out[command("vibration_rate")] = from.vibration_rate_Hz;
  out[command("vibration_batch")] = from.vibration_batch;
  out[command("vibration_count")] = static_cast<std::uint16_t>(from.duties.size());
  std::size_t at = command("vibration_duties");
  for (const DutyPair& pair : from.duties) {
    out[at++] =
        static_cast<std::uint16_t>((static_cast<std::uint8_t>(pair[0]) << 8U) | static_cast<std::uint8_t>(pair[1]));
  }
  return at;
}

bool decode(std::span<const std::uint16_t> in, DeviceCommand& out) {
  if (in.size() < kCommandHead || in.size() > kCommandRegisters) return false;
  out.control_word = in[command("control_word")];
  out.heartbeat = in[command("heartbeat")];
  out.nonce = in[command("nonce")];
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    out.reference_ticks[i] = signedOf(in[command("reference_1") + i]);
  }
  out.vibration_rate_Hz = in[command("vibration_rate")];
  out.vibration_batch = in[command("vibration_batch")];
  out.duties.clear();
  const std::size_t count = in[command("vibration_count")];
  if (out.vibration_rate_Hz < 1 || out.vibration_rate_Hz > kLargestRate_Hz) return false;
  if (count > kVibrationBatch || kCommandHead + count > in.size()) return false;
  for (const std::uint16_t two : in.subspan(kCommandHead, count)) {
    const auto high = static_cast<std::int8_t>(two >> 8U);
    const auto low = static_cast<std::int8_t>(two & 0xFFU);
    static_cast<void>(
        out.duties.push({std::clamp<std::int8_t>(high, -100, 100), std::clamp<std::int8_t>(low, -100, 100)}));
  }
  return true;
}

}  // namespace fyd::protocol
