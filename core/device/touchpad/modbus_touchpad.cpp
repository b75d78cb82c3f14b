#include "core/device/touchpad/modbus_touchpad.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/device/touchpad/reading_values.h"

namespace fyd::device {
namespace {

using protocol::DriveState;

constexpr int kAttempts = 4;            // to read a block that is torn
constexpr int kSwitchingOnCycles = 50;  // a healthy drive needs five
constexpr std::uint16_t kLoopRate_Hz = 1000;
constexpr Duration kLongestStandstill = std::chrono::milliseconds(250);
constexpr std::string_view kDisobeys =
    sentence("the touchpad does not obey what is written to it (bit 9 of its status word)");

ModbusAddress within(ModbusAddress address, const DeviceParameters& parameters) {
  if (!parameters.serial_by_id.empty()) address.by_id = parameters.serial_by_id;
  return address;
}

}  // namespace

bool deviceRestarted(std::uint32_t before_us, std::uint32_t now_us, Duration elapsed) {
  const double counted_s = static_cast<double>(now_us - before_us) * 1e-6;  // modulo 2³², a wrap is no restart
  const double expected_s = toSeconds(elapsed);
  return std::abs(counted_s - expected_s) > std::max(1.0, 0.1 * expected_s);
}

ModbusTouchpad::ModbusTouchpad(const ModbusAddress& address, const DeviceParameters& parameters)
    : parameters_(parameters),
      expected_serial_(address.serial),
      link_(within(address, parameters), fromSeconds(parameters.response_timeout_ms / 1e3),
            fromSeconds(parameters.quiet_ms / 1e3)),
      period_(fromSeconds(1.0 / parameters.cycle_rate_Hz)) {
  // Random, so that a restarted program does not go on with the last one's numbers.
  std::random_device seed;
  command_.nonce = static_cast<std::uint16_t>(seed());
  command_.vibration_batch = static_cast<std::uint16_t>(seed());
  command_.vibration_rate_Hz = kLoopRate_Hz;
}

ModbusTouchpad::~ModbusTouchpad() = default;

Message ModbusTouchpad::description() const {
  if (!identified_) return say("touchpad at {}", link_.name());
  return say("touchpad {}, firmware {}.{}, at {}", identity_.serialText(), identity_.firmware >> 8U,
             identity_.firmware & 0xFFU, link_.name());
}

Result<void> ModbusTouchpad::checkIdentity() {
  protocol::IdentityRegisters registers{};
  if (auto read = link_.read(protocol::kIdentityAddress, registers); !read) return read;
  identity_ = protocol::decodeIdentity(registers);
  if (identity_.magic != protocol::kMapMagic) {
    return fail("{}: not a touchpad: its first registers say 0x{:08X}, expected 0x{:08X}", link_.name(),
                identity_.magic, protocol::kMapMagic);
  }
  if ((identity_.map_version >> 8U) != (protocol::kMapVersion >> 8U)) {
    return fail("{}: register map {}.{}, this program knows {}.x; update the older of the two", link_.name(),
                identity_.map_version >> 8U, identity_.map_version & 0xFFU, protocol::kMapVersion >> 8U);
  }
  if (identity_.ir_sensors != protocol::kMapIrSensors || identity_.motors != control::kMotorCount) {
    return fail("{}: {} IR sensors and {} motors, expected {} and {}", link_.name(), identity_.ir_sensors,
                identity_.motors, protocol::kMapIrSensors, control::kMotorCount);
  }
  // Another touchpad has another calibration: the profile of this session would not fit it.
  if (!expected_serial_.empty() && identity_.serialText() != expected_serial_) {
    return fail(
        "{}: another touchpad answers: '{}', expected '{}'; plug the right one in, or open a session for this one",
        link_.name(), identity_.serialText(), expected_serial_);
  }
  return {};
}

Result<void> ModbusTouchpad::connect() {
  if (auto opened = link_.open(); !opened) return opened;
  if (auto known = checkIdentity(); !known) {
    link_.close();
    return known;
  }
  const std::array<std::uint16_t, protocol::kSettingsRegisters> settings = {
      static_cast<std::uint16_t>(std::lround(parameters_.watchdog_ms)),
      static_cast<std::uint16_t>(std::lround(parameters_.thermal_limit_degC * 10.0))};
  if (auto set = link_.write(protocol::kSettingsAddress, settings); !set) {
    link_.close();
    return set;
  }
  identified_ = true;
  if (expected_serial_.empty()) expected_serial_ = identity_.serialText();
  ++counters_.connections;
  last_uptime_us_.reset();
  return {};
}

Result<std::string> ModbusTouchpad::askSerial() {
  if (auto opened = link_.open(); !opened) return tl::unexpected(opened.error());
  const auto known = checkIdentity();
  link_.close();
  if (!known) return tl::unexpected(known.error());
  return std::string(identity_.serialText());
}

/// Called after a failed exchange. A device that was switching on must not begin to move when it comes back. One whose
/// motors stayed on through a short disturbance may go on: its own watchdog decides, and followDrive sees the result.
tl::unexpected<Error> ModbusTouchpad::lost(Error error) {
  if (arming_ == Arming::switching_on) {
    arming_ = Arming::refused;
    refusal_ = say("the touchpad was lost while its motors were being switched on");
  }
  return tl::unexpected(std::move(error));
}

void ModbusTouchpad::followCommand(bool active) {
  if (!active) {
    arming_ = Arming::off;
  } else if (!was_active_) {
    refusal_ = {};
    arming_ = Arming::switching_on;
    acknowledge_fault_ = true;
    cycles_switching_on_ = 0;
  }
  was_active_ = active;
}

void ModbusTouchpad::followDrive(DriveState state) {
  drive_ = state;
  const bool running = state == DriveState::operation_enabled;
  const auto refuse = [&] {
    arming_ = Arming::refused;
    refusal_ = say("the touchpad's motors are in the state {}", phrase(toString(state)));
    if (state_.fault_code != 0) {
      refusal_ = explained(refusal_, phrase(toString(static_cast<protocol::DriveFault>(state_.fault_code))));
    }
  };
  if (arming_ == Arming::on && !running) refuse();
  if (arming_ == Arming::switching_on) {
    if (state != DriveState::fault) acknowledge_fault_ = false;
    if (running)
      arming_ = Arming::on;
    else if (++cycles_switching_on_ > kSwitchingOnCycles)
      refuse();
  }
}

/// A device whose status word says that it does not take commands: the motors count as not driven by this program.
void ModbusTouchpad::followObedience() {
  obeys_ = (state_.status_word & protocol::status_bit::kRemote) != 0;
  if (obeys_ || arming_ == Arming::off || arming_ == Arming::refused) return;
  arming_ = Arming::refused;
  refusal_ = phrase(kDisobeys);
}

void ModbusTouchpad::queueVibration(std::span<const VibrationDuty> duties) {
  for (const VibrationDuty& duty : duties) {
    if (command_.duties.full()) {  // late: the newest matter
      std::copy(command_.duties.begin() + 1, command_.duties.end(), command_.duties.items.begin());
      --command_.duties.count;
      ++counters_.duties_lost;
    }
    static_cast<void>(command_.duties.push(protocol::toDutyPair(duty)));
  }
}

void ModbusTouchpad::prepare(const control::MotorCommand& command) {
  const bool operate = arming_ == Arming::switching_on || arming_ == Arming::on;
  command_.control_word = protocol::nextControlWord(drive_, operate, acknowledge_fault_);
  // Only while the motors shall be on: one that does not obey an "off" is switched off by its own watchdog.
  if (operate) ++command_.heartbeat;
  command_.reference_ticks = command.reference_ticks;
  if (!operate) {
    command_.duties.clear();
  } else if (command_.duties.empty()) {
    static_cast<void>(command_.duties.push(protocol::toDutyPair(command.vibration_duty_percent)));
  }
  ++command_.vibration_batch;
}

Result<void> ModbusTouchpad::transact() {
  protocol::CommandRegisters out{};
  protocol::StateRegisters in{};
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    ++command_.nonce;
    const std::size_t count = protocol::encode(command_, out);
    if (auto done = link_.writeAndRead(protocol::kCommandAddress, {out.data(), count}, protocol::kStateAddress, in);
        !done) {
      return done;
    }
    ++counters_.transactions;
    const protocol::StateProblem problem = protocol::decode(in, state_);
    if (state_.nonce_echo != command_.nonce) {
      ++counters_.stale_answers;
      link_.recover();
      return fail(
          "{}: an answer to an earlier question was refused; does the touchpad need longer than "
          "device.response_timeout_ms = {}?",
          link_.name(), parameters_.response_timeout_ms);
    }
    if (problem == protocol::StateProblem::none) return {};
    if (problem != protocol::StateProblem::torn) return fail(about(link_.name(), describe(problem, state_)));
    ++counters_.torn_blocks;
  }
  return fail("{}: {}, {} times in a row", link_.name(), describe(protocol::StateProblem::torn, state_), kAttempts);
}

/// Behind an adapter that stays plugged in, another touchpad, or the same one without its settings, answers on the open
/// connection. The next exchange identifies it, before anything of it is believed.
Result<void> ModbusTouchpad::checkClock(Instant now) {
  if (!last_uptime_us_ || !deviceRestarted(*last_uptime_us_, state_.uptime_us, now - last_answer_)) return {};
  ++counters_.restarts;
  const Message restarted = say("the touchpad restarted");
  if (arming_ != Arming::off) {
    arming_ = Arming::refused;
    refusal_ = restarted;
  }
  link_.close();
  return fail(about(link_.name(), restarted));
}

void ModbusTouchpad::take(Instant now) {
  // Encoders, currents and duties have no count of their own: they get the age of the set of values they belong to.
  const bool new_set =
      !last_set_ || (state_.sequence != last_set_->sequence && state_.uptime_us != last_set_->uptime_us);
  last_set_ = {.sequence = state_.sequence, .uptime_us = state_.uptime_us};
  if (new_set) last_new_set_ = now;
  stands_still_ = now - last_new_set_ > kLongestStandstill;
  // Dated with the sending of the request: a reading is never younger than its date.
  const bool ir_news = readings_.ir.count == 0 || state_.ir_count != last_ir_count_;
  const bool bridge_news = readings_.bridge.count == 0 || state_.bridge_count != last_bridge_count_;
  last_ir_count_ = state_.ir_count;
  last_bridge_count_ = state_.bridge_count;
  last_uptime_us_ = state_.uptime_us;
  last_answer_ = now;
  if (ir_news) {
    sensing::IrCounts counts;
    for (const std::uint16_t code : state_.ir) static_cast<void>(counts.push(code));
    readings_.ir.set(counts, now - fromSeconds(state_.ir_age_ms / 1e3));
  }
  if (bridge_news && std::isfinite(state_.bridge_mV_per_V)) {
    readings_.bridge.set({.value_mV_per_V = state_.bridge_mV_per_V}, now - fromSeconds(state_.bridge_age_ms / 1e3));
  }
  if (arming_ != Arming::refused && obeys_ && new_set) readings_.motors.set(state_.motors, now);
}

Result<TouchpadReadings> ModbusTouchpad::exchange(const control::MotorCommand& command, Instant now) {
  followCommand(command.active);
  if (!link_.isOpen()) {
    if (auto connected = connect(); !connected) return lost(connected.error());
  }
  prepare(command);
  const auto done = transact();
  command_.duties.clear();
  if (!done) return lost(done.error());
  if (const auto same = checkClock(now); !same) return lost(same.error());
  followDrive(protocol::driveStateOf(state_.status_word).value_or(DriveState::not_ready_to_switch_on));
  followObedience();
  take(now);
  return readings_;
}

std::vector<DeviceReport> ModbusTouchpad::reports() const {
  DeviceReport out{.part = Part::touchpad,
                   .kind = verbatim(link_.name().starts_with("modbus-tcp") ? "Modbus TCP" : "Modbus RTU"),
                   .description = description()};
  out.counters = {{say("stale answers"), counters_.stale_answers},
                  {say("torn blocks"), counters_.torn_blocks},
                  {say("connections"), counters_.connections},
                  {say("device restarts"), counters_.restarts},
                  {say("vibration duties lost here"), counters_.duties_lost},
                  {say("vibration duties lost there"), state_.vibration_lost}};
  if (readings_.ir.count == 0 && readings_.motors.count == 0) return {std::move(out)};
  addSensorValues(readings_, out.values);
  addMotorValues(readings_.motors, out.values);
  for (std::size_t i = 0; i < state_.temperature_degC.size(); ++i) {
    out.values.push_back({.name = say("temperature {}", i + 1), .number = state_.temperature_degC[i], .unit = "°C"});
  }
  const auto text = [&out](Message name, Message words) {
    out.values.push_back({.name = std::move(name), .text = std::move(words)});
  };
  text(say("motors"), phrase(toString(drive_)));
  text(say("status word"), verbatim(protocol::statusInWords(state_.status_word)));
  if (state_.fault_code != 0) {
    text(say("fault"), phrase(toString(static_cast<protocol::DriveFault>(state_.fault_code))));
  }
  out.values.push_back(serialValue(identity_.serialText()));
  text(say("firmware"), verbatim(fmt::format("{}.{}", identity_.firmware >> 8U, identity_.firmware & 0xFFU)));
  out.values.push_back({.name = say("clock"), .number = state_.uptime_us * 1e-6, .unit = "s"});
  return {std::move(out)};
}

Message ModbusTouchpad::whySwitchedOff() const {
  return refusal_.empty() ? Message{} : say("{}: mend that, then arm again", refusal_);
}

Message ModbusTouchpad::complaint() const {
  if (arming_ == Arming::refused) return whySwitchedOff();
  if (!obeys_) return say("{}: set it to remote, and close what else drives it", phrase(kDisobeys));
  if (stands_still_)
    return say("the touchpad answers, but its clock or its count of value sets stands still: switch it off and on");
  if ((state_.status_word & protocol::status_bit::kWarning) != 0) {
    return say("motors at {:.0f} and {:.0f} °C, switched off at {:.0f}: let them cool", state_.temperature_degC[0],
               state_.temperature_degC[1], parameters_.thermal_limit_degC);
  }
  return {};
}

}  // namespace fyd::device
