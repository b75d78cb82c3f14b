// The touchpad's Modbus registers, declared once: the codec, the client, the simulated device and the manual's table
// all come from this list. Holding registers, addresses from 0, unit 1.
//
// Conventions: 32-bit values take two registers, the high word first (floats ABCD), on even addresses. A scaled value
// is register · scale in the unit. The block `state` is read and the block `command` written in one transaction of
// function 0x17, which writes before it reads.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace fyd::protocol {

enum class RegisterType : std::uint8_t { u16, i16, u32, f32, text, duty_pair };
enum class RegisterAccess : std::uint8_t { read, write };  ///< write: can be read back as well

struct RegisterInfo {
  std::string_view name;
  std::uint16_t address = 0;
  std::uint16_t registers = 1;
  RegisterType type = RegisterType::u16;
  std::string_view unit;  ///< empty: a plain number
  double scale = 1.0;
  RegisterAccess access = RegisterAccess::read;
  std::string_view help;
};

inline constexpr std::uint32_t kMapMagic = 0x46594454;  ///< "FYDT"
/// High byte: a client knows only its own; low byte: grows with additions that older clients may ignore.
inline constexpr std::uint16_t kMapVersion = 0x0100;
inline constexpr int kModbusUnit = 1;

inline constexpr std::uint16_t kIdentityAddress = 0;
inline constexpr std::uint16_t kIdentityRegisters = 15;
inline constexpr std::uint16_t kSettingsAddress = 32;
inline constexpr std::uint16_t kSettingsRegisters = 2;
inline constexpr std::uint16_t kStateAddress = 64;
inline constexpr std::uint16_t kStateRegisters = 26;
inline constexpr std::uint16_t kDiagnosisAddress = 96;
inline constexpr std::uint16_t kDiagnosisRegisters = 10;
inline constexpr std::uint16_t kCommandAddress = 128;
inline constexpr std::uint16_t kCommandHead = 8;      ///< registers before the duties
inline constexpr std::uint16_t kVibrationBatch = 32;  ///< duties in one transaction at most
inline constexpr std::uint16_t kCommandRegisters = kCommandHead + kVibrationBatch;

// clang-format off
inline constexpr std::array kRegisters = {
    RegisterInfo{"magic", 0, 2, RegisterType::u32, "", 1, RegisterAccess::read, "0x46594454, the characters FYDT: this is a touchpad."},
    RegisterInfo{"map_version", 2, 1, RegisterType::u16, "", 1, RegisterAccess::read, "Version of this map: high byte major, low byte minor."},
    RegisterInfo{"firmware", 3, 1, RegisterType::u16, "", 1, RegisterAccess::read, "Version of the firmware: high byte major, low byte minor."},
    RegisterInfo{"serial", 4, 8, RegisterType::text, "", 1, RegisterAccess::read, "Serial number, 16 ASCII characters, filled up with NUL; two in a register, the first in the high byte."},
    RegisterInfo{"ir_sensors", 12, 1, RegisterType::u16, "", 1, RegisterAccess::read, "IR distance sensors: 3."},
    RegisterInfo{"motors", 13, 1, RegisterType::u16, "", 1, RegisterAccess::read, "Motors: 2."},
    RegisterInfo{"vibration_capacity", 14, 1, RegisterType::u16, "", 1, RegisterAccess::read, "Duties that one batch may carry."},

    RegisterInfo{"watchdog", 32, 1, RegisterType::u16, "ms", 1, RegisterAccess::write, "Longest standstill of the heartbeat, 20 to 1000; then the motors go off."},
    RegisterInfo{"thermal_limit", 33, 1, RegisterType::i16, "°C", 0.1, RegisterAccess::write, "Motor temperature estimate from which the motors go off, 40 to 125."},

    RegisterInfo{"sequence_begin", 64, 1, RegisterType::u16, "", 1, RegisterAccess::read, "Grows with each new set of values; unequal to sequence_end: the block was torn, read again."},
    RegisterInfo{"nonce_echo", 65, 1, RegisterType::u16, "", 1, RegisterAccess::read, "The nonce last written: proves that this answer belongs to this request."},
    RegisterInfo{"uptime", 66, 2, RegisterType::u32, "µs", 1, RegisterAccess::read, "Device clock; wraps after 71.6 minutes. Smaller than before without a wrap: the device restarted."},
    RegisterInfo{"status_word", 68, 1, RegisterType::u16, "", 1, RegisterAccess::read, "State of the motors, see the table of states."},
    RegisterInfo{"fault_code", 69, 1, RegisterType::u16, "", 1, RegisterAccess::read, "Why the state is fault: 0x3220 supply, 0x4310 temperature, 0x8130 heartbeat; else 0."},
    RegisterInfo{"bridge", 70, 2, RegisterType::f32, "mV/V", 1, RegisterAccess::read, "Load-cell bridge; NaN when it does not measure."},
    RegisterInfo{"bridge_age", 72, 1, RegisterType::u16, "ms", 0.1, RegisterAccess::read, "Age of the bridge's sample; saturates."},
    RegisterInfo{"bridge_count", 73, 1, RegisterType::u16, "", 1, RegisterAccess::read, "Samples of the bridge, wraps; unchanged: no news."},
    RegisterInfo{"ir_1", 74, 1, RegisterType::u16, "", 1, RegisterAccess::read, "ADC code of IR sensor 1, 0 to 4095."},
    RegisterInfo{"ir_2", 75, 1, RegisterType::u16, "", 1, RegisterAccess::read, "ADC code of IR sensor 2."},
    RegisterInfo{"ir_3", 76, 1, RegisterType::u16, "", 1, RegisterAccess::read, "ADC code of IR sensor 3."},
    RegisterInfo{"ir_age", 77, 1, RegisterType::u16, "ms", 0.1, RegisterAccess::read, "Age of the IR samples; saturates."},
    RegisterInfo{"ir_count", 78, 1, RegisterType::u16, "", 1, RegisterAccess::read, "Samples of the IR sensors, wraps; unchanged: no news."},
    RegisterInfo{"encoder_1", 79, 1, RegisterType::u16, "", 1, RegisterAccess::read, "Encoder of motor 1, 0 to 4095, 4096 a turn; taken at uptime."},
    RegisterInfo{"encoder_2", 80, 1, RegisterType::u16, "", 1, RegisterAccess::read, "Encoder of motor 2."},
    RegisterInfo{"current_1", 81, 1, RegisterType::i16, "mA", 1, RegisterAccess::read, "Current of motor 1, signed."},
    RegisterInfo{"current_2", 82, 1, RegisterType::i16, "mA", 1, RegisterAccess::read, "Current of motor 2."},
    RegisterInfo{"position_duty_1", 83, 1, RegisterType::i16, "%", 0.01, RegisterAccess::read, "Duty that the position loop of motor 1 uses; -32768: not known."},
    RegisterInfo{"position_duty_2", 84, 1, RegisterType::i16, "%", 0.01, RegisterAccess::read, "Duty that the position loop of motor 2 uses; -32768: not known."},
    RegisterInfo{"temperature_1", 85, 1, RegisterType::i16, "°C", 0.1, RegisterAccess::read, "Estimated winding temperature of motor 1."},
    RegisterInfo{"temperature_2", 86, 1, RegisterType::i16, "°C", 0.1, RegisterAccess::read, "Estimated winding temperature of motor 2."},
    RegisterInfo{"vibration_waiting", 87, 1, RegisterType::u16, "", 1, RegisterAccess::read, "Duties not yet played."},
    RegisterInfo{"vibration_lost", 88, 1, RegisterType::u16, "", 1, RegisterAccess::read, "Duties dropped because more came than could be played, wraps."},
    RegisterInfo{"sequence_end", 89, 1, RegisterType::u16, "", 1, RegisterAccess::read, "Equal to sequence_begin in a whole block."},

    RegisterInfo{"bridge_scaled", 96, 1, RegisterType::i16, "mV/V", 0.00025, RegisterAccess::read, "The bridge for masters without floats."},
    RegisterInfo{"drive_state", 97, 1, RegisterType::u16, "", 1, RegisterAccess::read, "State of the motors as a number, in the order of the table of states from 0."},
    RegisterInfo{"temperature_1_float", 98, 2, RegisterType::f32, "°C", 1, RegisterAccess::read, "temperature_1 as a float."},
    RegisterInfo{"temperature_2_float", 100, 2, RegisterType::f32, "°C", 1, RegisterAccess::read, "temperature_2 as a float."},
    RegisterInfo{"transactions", 102, 2, RegisterType::u32, "", 1, RegisterAccess::read, "Requests answered since the start."},
    RegisterInfo{"refused_writes", 104, 2, RegisterType::u32, "", 1, RegisterAccess::read, "Writes refused because another master drives the motors."},

    RegisterInfo{"control_word", 128, 1, RegisterType::u16, "", 1, RegisterAccess::write, "What the motors shall do, see the table of states."},
    RegisterInfo{"heartbeat", 129, 1, RegisterType::u16, "", 1, RegisterAccess::write, "Any value unlike the last one winds the watchdog up."},
    RegisterInfo{"nonce", 130, 1, RegisterType::u16, "", 1, RegisterAccess::write, "Read back as nonce_echo in the same transaction."},
    RegisterInfo{"reference_1", 131, 1, RegisterType::i16, "tick", 1, RegisterAccess::write, "Position reference of motor 1, 4200 ticks for 90°."},
    RegisterInfo{"reference_2", 132, 1, RegisterType::i16, "tick", 1, RegisterAccess::write, "Position reference of motor 2."},
    RegisterInfo{"vibration_rate", 133, 1, RegisterType::u16, "Hz", 1, RegisterAccess::write, "Duties of a batch in a second, 1 to 2000."},
    RegisterInfo{"vibration_batch", 134, 1, RegisterType::u16, "", 1, RegisterAccess::write, "Number of the batch; a batch with the number of the last one is not played again."},
    RegisterInfo{"vibration_count", 135, 1, RegisterType::u16, "", 1, RegisterAccess::write, "Duties that follow, 0 to 32; none: the last one is held for 10 ms, then zero."},
    RegisterInfo{"vibration_duties", 136, 32, RegisterType::duty_pair, "%", 1, RegisterAccess::write, "One register for each moment: signed duty of motor 1 in the high byte, of motor 2 in the low byte, -100 to 100."},
};
// clang-format on

/// At compile time, so that a misspelt name does not build.
[[nodiscard]] consteval std::uint16_t addressOf(std::string_view name) {
  for (const RegisterInfo& info : kRegisters) {
    if (info.name == name) return info.address;
  }
  throw std::logic_error("no such register");
}

/// nullptr when no register has this address.
[[nodiscard]] const RegisterInfo* registerAt(std::uint16_t address);

[[nodiscard]] std::string_view toString(RegisterType type);

/// The manual's tables: registers, states of the motors. Markdown.
[[nodiscard]] std::string registerMapMarkdown();

}  // namespace fyd::protocol
