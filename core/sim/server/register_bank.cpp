#include "core/sim/server/register_bank.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace fyd::sim {
namespace {

using protocol::addressOf;

constexpr Duration kOwnership = std::chrono::seconds(1);
constexpr std::array<std::uint16_t, protocol::kSettingsRegisters> kDefaultSettings = {100, 850};
constexpr std::uint16_t kFirmware = 0x0100;
constexpr double kWarningBelowLimit_degC = 10.0;
constexpr double kUnitsPerMillisecond = 1e3;  // of the device clock, µs

struct Block {
  int address;
  int registers;
};
constexpr std::array kBlocks = {Block{protocol::kIdentityAddress, protocol::kIdentityRegisters},
                                Block{protocol::kSettingsAddress, protocol::kSettingsRegisters},
                                Block{protocol::kStateAddress, protocol::kStateRegisters},
                                Block{protocol::kDiagnosisAddress, protocol::kDiagnosisRegisters},
                                Block{protocol::kCommandAddress, protocol::kCommandRegisters}};

bool within(const Block& block, int address, int count) {
  return count > 0 && address >= block.address && address + count <= block.address + block.registers;
}

void put32(RegisterBank::Image& image, std::size_t at, std::uint32_t value) {
  const auto words = protocol::split(value);
  image[at] = words[0];
  image[at + 1] = words[1];
}

double thermalLimit(std::span<const std::uint16_t> settings) { return settings[1] * 0.1; }

}  // namespace

void RegisterBank::restart(Instant now, protocol::DriveFault cause) {
  *this = RegisterBank(std::move(serial_));
  powered_since_ = now;
  last_heartbeat_ = now;
  settings_ = kDefaultSettings;
  static_cast<void>(protocol::encode(command_, command_image_));
  if (cause != protocol::DriveFault::none) drive_.fail(cause);
}

bool RegisterBank::readable(int address, int count) {
  return std::ranges::any_of(kBlocks, [&](const Block& block) { return within(block, address, count); });
}

bool RegisterBank::mayWrite(int master, Instant now) {
  if (owner_ && *owner_ != master && now - owner_wrote_ < kOwnership) {
    ++refused_writes_;
    return false;
  }
  owner_ = master;
  owner_wrote_ = now;
  return true;
}

void RegisterBank::forget(int master) {
  if (owner_ == master) owner_.reset();
}

ModbusException RegisterBank::write(int master, int address, std::span<const std::uint16_t> values, Instant now,
                                    bool obeys) {
  const auto count = static_cast<int>(values.size());
  const bool settings = within({protocol::kSettingsAddress, protocol::kSettingsRegisters}, address, count);
  const bool command = within({protocol::kCommandAddress, protocol::kCommandRegisters}, address, count);
  if (!settings && !command) return ModbusException::illegal_address;
  if (!mayWrite(master, now)) return ModbusException::busy;
  return settings ? writeSettings(static_cast<std::size_t>(address - protocol::kSettingsAddress), values)
                  : writeCommand(static_cast<std::size_t>(address - protocol::kCommandAddress), values, now, obeys);
}

ModbusException RegisterBank::writeSettings(std::size_t at, std::span<const std::uint16_t> values) {
  auto wanted = settings_;
  std::ranges::copy(values, wanted.begin() + static_cast<std::ptrdiff_t>(at));
  const bool good = wanted[0] >= 20 && wanted[0] <= 1000 && wanted[1] >= 400 && wanted[1] <= 1250;
  if (!good) return ModbusException::illegal_value;
  settings_ = wanted;
  return ModbusException::none;
}

ModbusException RegisterBank::writeCommand(std::size_t at, std::span<const std::uint16_t> values, Instant now,
                                           bool obeys) {
  auto wanted = command_image_;
  std::ranges::copy(values, wanted.begin() + static_cast<std::ptrdiff_t>(at));
  protocol::DeviceCommand command;
  if (!protocol::decode(wanted, command)) return ModbusException::illegal_value;
  obeys_ = obeys;
  command_image_ = wanted;
  if (command.heartbeat != command_.heartbeat) last_heartbeat_ = now;
  if (!obeys) {  // the motors' command stays
    command_.heartbeat = command.heartbeat;
    command_.nonce = command.nonce;
    return ModbusException::none;
  }
  if (command.vibration_batch != command_.vibration_batch) {
    vibration_.push(command.duties.view(), command.vibration_rate_Hz, now);
  }
  command_ = command;
  drive_.control(command.control_word);
  if (!drive_.energised()) vibration_.clear();
  return ModbusException::none;
}

void RegisterBank::supervise(Instant now, const std::array<double, control::kMotorCount>& temperature_degC) {
  temperature_degC_ = temperature_degC;
  if (drive_.state() == protocol::DriveState::switch_on_disabled) return;
  if (now - last_heartbeat_ > std::chrono::milliseconds(settings_[0])) drive_.fail(protocol::DriveFault::heartbeat);
  if (std::ranges::max(temperature_degC) >= thermalLimit(settings_)) {
    drive_.fail(protocol::DriveFault::over_temperature);
  }
  if (!drive_.energised()) vibration_.clear();
}

control::MotorCommand RegisterBank::commandAt(Instant now) {
  const protocol::DutyPair duty = vibration_.at(now);
  control::MotorCommand out{.reference_ticks = command_.reference_ticks, .active = drive_.energised()};
  for (std::size_t i = 0; i < duty.size(); ++i) out.vibration_duty_percent[i] = out.active ? duty[i] : 0.0;
  return out;
}

protocol::DeviceState RegisterBank::stateFor(int master, const device::TouchpadReadings& readings, Instant now) {
  protocol::DeviceState out;
  out.sequence = ++sequence_;
  out.nonce_echo = command_.nonce;
  // A server may have read its time before another thread began the brown-out that ends later than that.
  const Duration up = std::max(now - powered_since_, Duration::zero());
  out.uptime_us = static_cast<std::uint32_t>(static_cast<std::uint64_t>(toMilliseconds(up) * kUnitsPerMillisecond));
  out.status_word = statusBits(drive_.state()) | protocol::status_bit::kVoltageEnabled;
  if (owner_ == master && obeys_) out.status_word |= protocol::status_bit::kRemote;
  if (std::ranges::max(temperature_degC_) >= thermalLimit(settings_) - kWarningBelowLimit_degC) {
    out.status_word |= protocol::status_bit::kWarning;
  }
  if (drive_.fault() == protocol::DriveFault::heartbeat) out.status_word |= protocol::status_bit::kWatchdogExpired;
  out.fault_code = static_cast<std::uint16_t>(drive_.fault());
  out.bridge_mV_per_V = readings.bridge.count == 0 ? std::numeric_limits<float>::quiet_NaN()
                                                   : static_cast<float>(readings.bridge.value.value_mV_per_V);
  out.bridge_age_ms = toMilliseconds(now - readings.bridge.taken);
  out.bridge_count = static_cast<std::uint16_t>(readings.bridge.count);
  std::copy_n(readings.ir.value.begin(), std::min(out.ir.size(), readings.ir.value.size()), out.ir.begin());
  out.ir_age_ms = toMilliseconds(now - readings.ir.taken);
  out.ir_count = static_cast<std::uint16_t>(readings.ir.count);
  out.motors = readings.motors.value;
  out.temperature_degC = temperature_degC_;
  out.vibration_waiting = static_cast<std::uint16_t>(vibration_.waiting());
  out.vibration_lost = vibration_.lost();
  return out;
}

void RegisterBank::fill(Image& image, int master, const device::TouchpadReadings& readings, Instant now) {
  ++transactions_;
  protocol::DeviceIdentity identity;
  identity.firmware = kFirmware;
  identity.setSerial(serial_);
  const protocol::DeviceState state = stateFor(master, readings, now);
  std::ranges::copy(encode(identity), image.begin() + protocol::kIdentityAddress);
  std::ranges::copy(settings_, image.begin() + protocol::kSettingsAddress);
  std::ranges::copy(encode(state), image.begin() + protocol::kStateAddress);
  std::ranges::copy(command_image_, image.begin() + protocol::kCommandAddress);
  image[addressOf("bridge_scaled")] = static_cast<std::uint16_t>(
      static_cast<std::int16_t>(std::lround(readings.bridge.value.value_mV_per_V / 0.00025)));
  image[addressOf("drive_state")] = static_cast<std::uint16_t>(drive_.state());
  put32(image, addressOf("temperature_1_float"),
        std::bit_cast<std::uint32_t>(static_cast<float>(temperature_degC_[0])));
  put32(image, addressOf("temperature_2_float"),
        std::bit_cast<std::uint32_t>(static_cast<float>(temperature_degC_[1])));
  put32(image, addressOf("transactions"), static_cast<std::uint32_t>(transactions_));
  put32(image, addressOf("refused_writes"), static_cast<std::uint32_t>(refused_writes_));
}

}  // namespace fyd::sim
