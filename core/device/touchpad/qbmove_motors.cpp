#include "core/device/touchpad/qbmove_motors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/device/stable_name.h"
#include "core/device/touchpad/reading_values.h"

namespace fyd::device {
namespace {

namespace qb = protocol::qbmove;

constexpr int kFailuresUntilLost = 3;
constexpr int kActivationEvery = 50;  // exchanges
constexpr std::string_view kLost = sentence("was lost while its motors were on");
constexpr std::string_view kNotRenewed = sentence("was switched off because its command was not renewed in time");

std::int16_t percentOf(double duty) {
  return std::isnan(duty) ? std::int16_t{0} : static_cast<std::int16_t>(std::lround(std::clamp(duty, -100.0, 100.0)));
}

}  // namespace

std::uint16_t encoderCountsOf(std::int16_t ticks, const DeviceParameters& parameters) {
  const double sign = parameters.qbmove_encoder_sign < 0 ? -1.0 : 1.0;
  const double degrees = sign * ticks / parameters.qbmove_ticks_per_degree;
  const long counts = std::lround(degrees * control::kEncoderCountsPerDegree);
  return static_cast<std::uint16_t>(static_cast<unsigned long>(counts) & 0xFFFU);
}

QbmoveMotors::QbmoveMotors(std::string port, const DeviceParameters& parameters)
    : path_(std::move(port)), parameters_(parameters) {}

Message QbmoveMotors::description() const {
  if (parameters_.qbmove_vibration_opcode != 0) {
    return say("motor board {} at {}, {} Bd", parameters_.qbmove_id, path_, parameters_.qbmove_baud);
  }
  return say("motor board {} at {}, {} Bd, no vibration (device.qbmove_vibration_opcode is not set)",
             parameters_.qbmove_id, path_, parameters_.qbmove_baud);
}

DeviceReport QbmoveMotors::report() const {
  DeviceReport out{.part = Part::motor_board, .kind = verbatim("qbmove"), .description = description()};
  out.counters = {{say("answers missing"), late_replies_},
                  {say("connections"), connections_},
                  {say("switched off by itself"), switched_off_}};
  addMotorValues(newest_, out.values);
  out.values.push_back({.name = say("motors"), .text = energised_ ? say("on") : say("off")});
  return out;
}

Message QbmoveMotors::whySwitchedOff() const {
  if (refusal_.empty()) return {};
  return say("motor board {} at {} {}: mend that, then arm again", parameters_.qbmove_id, path_, refusal_);
}

void QbmoveMotors::refuse(std::string_view why) {
  refused_ = true;
  refusal_ = phrase(why);
}

void QbmoveMotors::lose(std::string_view why) {
  if (energised_) refuse(why);
  energised_ = off_confirmed_ = false;
  parser_.reset();
}

Result<void> QbmoveMotors::send(protocol::QbmoveFrame frame) {
  frame.id = static_cast<std::uint8_t>(parameters_.qbmove_id);
  const protocol::QbmoveBytes bytes = protocol::encode(frame);
  if (port_->write(bytes.view())) return {};
  lose(kLost);
  port_.reset();
  return fail(explainPort(path_, EIO));
}

Result<protocol::QbmoveFrame> QbmoveMotors::ask(std::uint8_t command, std::size_t payload_bytes) {
  // The protocol has no sequence numbers: discard what arrived before the request.
  port_->flush();
  parser_.reset();
  if (auto sent = send(protocol::qbmoveFrame(command)); !sent) return tl::unexpected(sent.error());
  const Instant deadline = Clock::now() + fromSeconds(parameters_.qbmove_timeout_ms / 1e3);
  std::array<std::uint8_t, 64> buffer{};
  do {
    const int got = port_->read(buffer, deadline);
    if (got < 0) {
      lose(kLost);
      port_.reset();
      return fail(explainPort(path_, EIO));
    }
    for (int i = 0; i < got; ++i) {
      const auto frame = parser_.push(buffer[static_cast<std::size_t>(i)]);
      if (frame && frame->id == parameters_.qbmove_id && frame->command == command &&
          frame->payload.size() == payload_bytes) {
        return *frame;
      }
    }
  } while (Clock::now() < deadline);
  ++late_replies_;
  return fail(
      "motor board {} at {}: no answer to command {} in {} ms; is it on, and are device.qbmove_baud = {} and "
      "device.qbmove_id right?",
      parameters_.qbmove_id, path_, command, parameters_.qbmove_timeout_ms, parameters_.qbmove_baud);
}

Result<void> QbmoveMotors::connect() {
  const auto path = resolveDevice(path_, folderOr(parameters_.serial_by_id, kSerialById));
  if (!path) return tl::unexpected(path.error());
  auto port = SerialPort::open(*path, parameters_.qbmove_baud);
  if (!port) return tl::unexpected(port.error());
  port_ = std::move(*port);
  parser_.reset();
  off_confirmed_ = false;
  if (auto reply = ask(qb::kPing, 0); !reply) {
    port_.reset();
    return tl::unexpected(reply.error());
  }
  ++connections_;
  return {};
}

Result<void> QbmoveMotors::follow(const control::MotorCommand& command) {
  if (command.active != energised_) {
    if (command.active) {  // each time: a board that restarted meanwhile has none, and says nothing of it
      const double units = std::round(parameters_.qbmove_watchdog_ms / qb::kWatchdogUnit_ms);
      const auto limit = static_cast<std::uint8_t>(std::clamp(units, 1.0, 255.0));
      if (auto sent = send(protocol::qbmoveByteFrame(qb::kSetWatchdog, limit)); !sent) return sent;
    }
    off_confirmed_ = false;
    if (command.active) {
      if (auto sent = send(protocol::qbmoveByteFrame(qb::kActivate, qb::kMotorsOn)); !sent) return sent;
    }
    energised_ = command.active;
  }
  if (!energised_) {  // a damaged frame is not obeyed, and nothing says so: until the board itself says that it is off
    return off_confirmed_ ? Result<void>{} : send(protocol::qbmoveByteFrame(qb::kActivate, qb::kMotorsOff));
  }
  if (auto sent = send(protocol::qbmoveFrame(qb::kSetInputs, command.reference_ticks)); !sent) return sent;
  if (parameters_.qbmove_vibration_opcode == 0) return {};
  std::array<std::int16_t, control::kMotorCount> duty = {percentOf(command.vibration_duty_percent[0]),
                                                         percentOf(command.vibration_duty_percent[1])};
  if (parameters_.qbmove_vibration_swapped) std::swap(duty[0], duty[1]);
  return send(protocol::qbmoveFrame(static_cast<std::uint8_t>(parameters_.qbmove_vibration_opcode), duty));
}

Result<control::MotorFeedback> QbmoveMotors::measure() {
  const auto positions = ask(qb::kGetMeasurements, 6);  // two motors and the output shaft
  if (!positions) return tl::unexpected(positions.error());
  const auto currents = ask(qb::kGetCurrents, 4);
  if (!currents) return tl::unexpected(currents.error());
  control::MotorFeedback out;
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    out.encoder_counts[i] = encoderCountsOf(positions->at(i).value_or(0), parameters_);
    out.current_mA[i] = currents->at(i).value_or(0);
    if (std::abs(out.current_mA[i]) > control::kLargestCurrent_mA) {
      return fail("motor board {} at {}: current {} is {} mA, expected -{} to {}", parameters_.qbmove_id, path_, i + 1,
                  out.current_mA[i], control::kLargestCurrent_mA, control::kLargestCurrent_mA);
    }
  }
  return out;
}

Result<void> QbmoveMotors::checkActivation() {
  const bool due = ++exchanges_ % kActivationEvery == 0;
  if (!due && (energised_ || off_confirmed_)) return {};
  const auto mode = ask(qb::kGetActivate, 1);
  if (!mode) return tl::unexpected(mode.error());
  const bool off = mode->payload[0] == qb::kMotorsOff;
  if (energised_ && off) {
    ++switched_off_;
    lose(sentence("has switched its motors off by itself"));
  }
  if (energised_) return {};
  off_confirmed_ = off;
  if (off) return {};
  return fail("motor board {} at {} does not obey: its motors are on, expected off; switch off its supply",
              parameters_.qbmove_id, path_);
}

Result<control::MotorFeedback> QbmoveMotors::exchange(const control::MotorCommand& command, bool renewed) {
  if (!command.active) refused_ = false;
  if (command.active && !was_active_) refusal_ = {};
  if (command.active && !renewed && !refused_) refuse(kNotRenewed);
  was_active_ = command.active;
  if (!port_) {
    if (auto connected = connect(); !connected) {
      if (command.active) refuse(kLost);
      return tl::unexpected(connected.error());
    }
  }
  control::MotorCommand obeyed = command;
  obeyed.active = command.active && !refused_;
  if (auto followed = follow(obeyed); !followed) return tl::unexpected(followed.error());
  auto measured = measure();
  if (measured) {
    if (auto checked = checkActivation(); !checked) measured = tl::unexpected(checked.error());
  }
  if (!measured) {
    if (++failures_ >= kFailuresUntilLost) lose(kLost);
    return measured;
  }
  failures_ = 0;
  newest_.set(*measured, Clock::now());
  if (!refused_) return measured;
  return fail(whySwitchedOff());
}

}  // namespace fyd::device
