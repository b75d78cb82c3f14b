#include "core/protocol/classic/classic_robot_end.h"

#include <algorithm>

namespace fyd::protocol {
namespace {

using pipeline::RobotCommand;

// A touchpad that sends no pictures although asked would otherwise cost a time-out in every cycle.
constexpr int kPicturesMissedUntilOff = 3;

}  // namespace

ClassicRobotEnd::ClassicRobotEnd(const ClassicRobotSettings& settings, const Endpoint& touchpad)
    : settings_(settings),
      configured_touchpad_(touchpad),
      touchpad_(touchpad),
      incoming_image_(kClassicMaximumImage),
      image_(kClassicMaximumImage) {}

bool ClassicRobotEnd::command(RobotCommand command) { return commands_.push(command); }

std::span<const Datagram> ClassicRobotEnd::tick(Instant now, const RobotReport& report) {
  outgoing_.clear();
  if (phase_ == RobotPhase::closing && now - *closing_since_ >= settings_.closing) phase_ = RobotPhase::closed;
  if (phase_ == RobotPhase::closed) return {};
  if (phase_ != RobotPhase::handshake && due_ != Due::nothing) {
    if (now - state_sent_ < settings_.reply_timeout) {
      ++counters_.waited_cycles;
      return {};
    }
    giveUpCycle();
  }
  if (phase_ == RobotPhase::closed) return {};
  if (phase_ == RobotPhase::handshake) {
    const bool again = settings_.ack_retry > Duration::zero() && ack_sent_ && now - *ack_sent_ >= settings_.ack_retry;
    if (!ack_sent_ || again) sendAck(now);
  } else {
    sendState(now, report);
  }
  return outgoing_.view();
}

void ClassicRobotEnd::send(Bytes bytes) {
  const bool stored = outgoing_.push({.bytes = bytes, .to = touchpad_});
  static_cast<void>(stored);  // two a tick at most
}

void ClassicRobotEnd::sendAck(Instant now) {
  ack_bytes_ = encodeAck();
  send(ack_bytes_);
  ack_sent_ = now;
  due_ = Due::info_length;
  ++counters_.acks;
}

void ClassicRobotEnd::sendState(Instant now, const RobotReport& report) {
  if (motor_reference_wanted_) {
    motor_reference_wanted_ = false;
    motor_bytes_ = encodeMotorReference(report.motor_reference);
    send(motor_bytes_);
    ++counters_.motor_references;
  }
  RobotCommand command = RobotCommand::none;
  if (!commands_.empty() && phase_ != RobotPhase::closing) {
    command = commands_[0];
    std::copy(commands_.begin() + 1, commands_.end(), commands_.items.begin());
    --commands_.count;
  }
  state_bytes_ = encodeState({.command = command, .acceleration_g = report.acceleration_g, .robot = report.robot});
  send(state_bytes_);
  ++counters_.states;
  state_sent_ = now;
  due_ = Due::touch;
  act(command, now);
  info_wanted_ = command == RobotCommand::send_info_and_pause;
  image_wanted_ = images_on_;
}

void ClassicRobotEnd::act(RobotCommand command, Instant now) {
  switch (command) {
    case RobotCommand::send_info_and_pause: phase_ = RobotPhase::paused; break;
    case RobotCommand::resume: phase_ = RobotPhase::running; break;
    case RobotCommand::images_on:
      images_on_ = true;
      pictures_missed_ = 0;
      break;
    case RobotCommand::images_off: images_on_ = false; break;
    case RobotCommand::motor_reference_on: motor_reference_wanted_ = true; break;
    case RobotCommand::disconnect:
      phase_ = RobotPhase::closing;
      closing_since_ = now;
      break;
    default: break;
  }
}

void ClassicRobotEnd::giveUpCycle() {
  if (due_ == Due::touch) {
    ++counters_.missed_replies;
    ++misses_;
  } else {
    ++counters_.cycles_cut_short;
    if (image_wanted_ || due_ == Due::image_length || due_ == Due::image_bytes) ++pictures_missed_;
    if (pictures_missed_ >= kPicturesMissedUntilOff) images_on_ = false;
  }
  due_ = Due::nothing;
  info_wanted_ = false;
  image_wanted_ = false;
  if (misses_ < settings_.misses_until_lost) return;
  ++counters_.lost;
  misses_ = 0;
  images_on_ = false;
  motor_reference_wanted_ = false;
  commands_.clear();
  ack_sent_.reset();
  touchpad_ = configured_touchpad_;
  phase_ = phase_ == RobotPhase::closing ? RobotPhase::closed : RobotPhase::handshake;
}

RobotReception ClassicRobotEnd::handle(Bytes datagram, const Endpoint& from) {
  RobotReception out;
  // A touchpad that listens on every address of its host may answer the ACK from another one of them.
  const bool may_rename = phase_ == RobotPhase::handshake && due_ == Due::info_length && from.port == touchpad_.port;
  if (!(from == touchpad_) && !(may_rename && decodeInfoLength(datagram).ok())) {
    ++counters_.wrong_peer;
    return out;
  }
  if (phase_ == RobotPhase::closed || (phase_ == RobotPhase::handshake && due_ == Due::nothing)) {
    ++counters_.refused;
    return out;
  }
  const bool in_picture = due_ == Due::image_bytes;
  if (const auto touch = decodeTouch(datagram); touch.ok() && !in_picture && phase_ != RobotPhase::handshake) {
    takeTouch(touch.value, out);
    return out;
  }
  switch (due_) {
    case Due::nothing:
    case Due::touch: ++counters_.refused; break;
    case Due::info_length:
    case Due::info_text:
    case Due::info_values: takeInfo(datagram, from, out); break;
    case Due::image_length:
    case Due::image_bytes: takeImage(datagram, out); break;
  }
  return out;
}

RobotReception ClassicRobotEnd::handle(Bytes datagram, const Endpoint& from, Instant now) {
  const bool due = due_ == Due::touch;
  RobotReception out = handle(datagram, from);
  // The touchpad answers a state at once: its touch was under way for half of the time since then.
  if (out.touch) out.touch_sent = out.touch_seen = due ? now - (now - state_sent_) / 2 : now;
  return out;
}

void ClassicRobotEnd::nextDue() {
  if (info_wanted_) {
    info_wanted_ = false;
    due_ = Due::info_length;
  } else if (image_wanted_) {
    image_wanted_ = false;
    due_ = Due::image_length;
  } else {
    due_ = Due::nothing;
  }
}

void ClassicRobotEnd::takeTouch(const pipeline::TouchMessage& touch, RobotReception& out) {
  out.touch = touch;
  misses_ = 0;
  if (due_ != Due::touch) {
    ++counters_.extra_touches;
    return;
  }
  ++counters_.touches;
  nextDue();
}

void ClassicRobotEnd::takeInfo(Bytes datagram, const Endpoint& from, RobotReception& out) {
  if (due_ == Due::info_length) {
    const auto length = decodeInfoLength(datagram);
    if (length.ok()) {
      touchpad_ = from;
      board_expected_ = length.value;
      due_ = Due::info_text;
      return;
    }
  } else if (due_ == Due::info_text) {
    if (datagram.size() == board_expected_) {
      std::copy(datagram.begin(), datagram.end(), board_text_.begin());
      board_size_ = datagram.size();
      due_ = Due::info_values;
      return;
    }
  } else if (const auto values = decodeInfoValues(datagram); values.ok()) {
    info_ = values.value;
    out.info = true;
    ++counters_.infos;
    if (phase_ == RobotPhase::handshake) {
      phase_ = RobotPhase::running;
      out.connected = true;
    }
    nextDue();
    return;
  }
  ++counters_.refused;
}

void ClassicRobotEnd::takeImage(Bytes datagram, RobotReception& out) {
  if (due_ == Due::image_length) {
    const auto length = decodeImageLength(datagram);
    if (!length.ok()) {
      ++counters_.refused;
      return;
    }
    image_expected_ = length.value;
    incoming_size_ = 0;
    pictures_missed_ = 0;
    due_ = image_expected_ == 0 ? Due::nothing : Due::image_bytes;
    return;
  }
  if (datagram.size() > image_expected_ - incoming_size_) {
    ++counters_.refused;
    return;
  }
  std::ranges::copy(datagram, incoming_image_.begin() + static_cast<std::ptrdiff_t>(incoming_size_));
  incoming_size_ += datagram.size();
  if (incoming_size_ < image_expected_) return;
  std::swap(image_, incoming_image_);
  image_size_ = image_expected_;
  out.image = true;
  ++counters_.images;
  due_ = Due::nothing;
}

}  // namespace fyd::protocol
