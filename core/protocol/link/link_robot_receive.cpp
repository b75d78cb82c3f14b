// The robot's side of FYD Link: what it does with what arrives.
#include <algorithm>
#include <cmath>

#include "core/protocol/link/link_robot_end.h"

namespace fyd::protocol {
namespace {

using pipeline::RobotCommand;

constexpr double kTouchesMissed = 3.0;  // of a slow line, before a gap is one

}  // namespace

RobotReception LinkRobotEnd::handle(Bytes datagram, const Endpoint& from, Instant now) {
  RobotReception out;
  now_ = now;
  passTime(now);
  if (from != touchpad_) {
    ++counters_.wrong_peer;
    return out;
  }
  const LinkSorted sorted = sortDatagram(datagram);
  if (sorted.refusal != LinkRefusal::none) {
    refuse(sorted.refusal);
  } else if (sorted.kind == LinkKind::challenge) {
    takeChallenge(datagram);
  } else if (sorted.kind == LinkKind::answer) {
    takeAnswer(datagram, out);
  } else if (sorted.kind == LinkKind::sealed) {
    takeSealed(datagram, out);
  } else {
    refuse(LinkRefusal::kind);
  }
  return out;
}

void LinkRobotEnd::takeChallenge(Bytes datagram) {
  Cookie cookie{};
  if (phase_ != RobotPhase::handshake || !greeted_ || caller_) {
    refuse(LinkRefusal::phase);
    return;
  }
  if (const LinkRefusal refusal = readChallenge(key_, datagram, nonce_, cookie); refusal != LinkRefusal::none) {
    refuse(refusal);
    return;
  }
  caller_.emplace(key_, cookie, random_);
  const RobotHello hello{.sent_us = now_us_,
                         .rates = settings_.rates,
                         .workspace = settings_.workspace,
                         .capabilities = static_cast<std::uint32_t>(Capability::images) |
                                         static_cast<std::uint32_t>(Capability::motor_reference) |
                                         static_cast<std::uint32_t>(Capability::force),
                         .text = settings_.text};
  std::array<std::uint8_t, kMaximumLinkMessage> payload{};
  call_size_ = caller_->write(Bytes(payload).first(encodeHello(hello, payload)), call_);
  called_us_ = now_us_;
  next_try_us_ = now_us_;  // goes out with the next tick
  ++link_counters_.calls;
}

void LinkRobotEnd::takeAnswer(Bytes datagram, RobotReception& out) {
  if (phase_ != RobotPhase::handshake || !caller_) {
    refuse(LinkRefusal::phase);
    return;
  }
  std::array<std::uint8_t, kMaximumLinkDatagram> payload{};
  const auto opened = caller_->read(datagram, payload);
  if (!opened) {
    refuse(LinkRefusal::key);
    return;
  }
  const auto hello = decodeTouchpadHello(*opened);
  if (!hello.ok()) {
    refuse(hello.refusal);
    return;
  }
  const TouchpadHello& touchpad = hello.value;
  status_ = touchpad.status;
  const SessionKeys keys = caller_->keys();
  startOver();
  if (status_ != CallStatus::accepted) {
    next_try_us_ = now_us_ + microseconds(settings_.refused_pause);
    return;
  }
  rates_ = touchpad.rates;
  touch_code_ = *PositionCode::make(touchpad.workspace);
  connection_.emplace(keys.from_initiator, keys.from_responder, sessionOf(keys), 1e3 / rates_.touch_Hz, now_us_);
  connection_->learnClock(now_us_, touchpad.sent_us, touchpad.echo_us, touchpad.held_us, settings_.limits);
  takeInfo(touchpad.k_vib, touchpad.reference_ticks, touchpad.board_text);
  images_.reset();
  touch_.reset();
  state_sequence_ = 0;
  command_id_ = 0;
  next_beat_us_ = now_us_;  // the confirmation
  next_state_us_ = now_us_ + periodOf(rates_.state_Hz);
  phase_ = nextPhase(phase_, RobotEvent::answered);
  ++link_counters_.sessions;
  out.connected = true;
  out.info = true;
}

void LinkRobotEnd::takeInfo(double k_vib, const std::array<double, control::kMotorCount>& ticks,
                            std::string_view text) {
  info_ = {.k_vib = k_vib, .reference_ticks = ticks};
  board_size_ = std::min(text.size(), board_text_.size());
  std::copy_n(text.begin(), board_size_, board_text_.begin());
  ++counters_.infos;
}

void LinkRobotEnd::acknowledged() {
  ++link_counters_.commands;
  switch (outstanding_) {
    case RobotCommand::send_info_and_pause: phase_ = nextPhase(phase_, RobotEvent::pause); break;
    case RobotCommand::resume: phase_ = nextPhase(phase_, RobotEvent::resume); break;
    case RobotCommand::motor_reference_on: motor_references_on_ = true; break;
    case RobotCommand::motor_reference_off: motor_references_on_ = false; break;
    default: break;
  }
  outstanding_ = RobotCommand::none;
}

void LinkRobotEnd::takeSealed(Bytes datagram, RobotReception& out) {
  if (!connection_) {
    refuse(LinkRefusal::phase);
    return;
  }
  const LinkReceived received = connection_->receive(datagram, now_us_, settings_.limits);
  if (!received.ok()) {
    refuse(received.refusal);
    return;
  }
  phase_ = nextPhase(phase_, RobotEvent::heard);
  const LinkEnvelope& message = received.message;
  switch (message.type) {
    case LinkMessage::heartbeat: ++link_counters_.heartbeats; break;
    case LinkMessage::touch: takeTouch(received, out); break;
    case LinkMessage::command_ack: {
      const auto ack = decodeCommandAck(message);
      if (!ack.ok()) {
        refuse(ack.refusal);
      } else if (outstanding_ == RobotCommand::none || ack.value.id != command_id_) {
        refuse(LinkRefusal::late);
      } else if (outstanding_ != RobotCommand::send_info_and_pause) {
        acknowledged();
      }
      break;
    }
    case LinkMessage::info: {
      const auto info = decodeInfo(message);
      if (!info.ok()) {
        refuse(info.refusal);
        break;
      }
      takeInfo(info.value.k_vib, info.value.reference_ticks, info.value.board_text);
      out.info = true;
      if (outstanding_ == RobotCommand::send_info_and_pause) acknowledged();
      break;
    }
    case LinkMessage::image: {
      const auto fragment = decodeImageFragment(message);
      if (!fragment.ok()) {
        refuse(fragment.refusal);
      } else if (images_.take(fragment.value)) {
        out.image = true;
        ++counters_.images;
      }
      break;
    }
    case LinkMessage::goodbye:
      if (const auto goodbye = decodeGoodbye(message); goodbye.ok()) {
        phase_ = nextPhase(phase_, RobotEvent::goodbye);
        commands_.clear();
        startOver();
        next_try_us_ = now_us_ + microseconds(settings_.refused_pause);
      } else {
        refuse(goodbye.refusal);
      }
      break;
    default: refuse(LinkRefusal::message);
  }
}

void LinkRobotEnd::takeTouch(const LinkReceived& received, RobotReception& out) {
  const auto decoded = decodeTouch(received.message, touch_code_);
  if (!decoded.ok()) {
    refuse(decoded.refusal);
    return;
  }
  const LinkTouch& touch = decoded.value;
  // Heartbeats alone do not make touches follow each other: whoever drops or delays only these, and lets them through
  // again, must not lead the arm to where the finger went meanwhile.
  const double gap_ms = 1e-3 * static_cast<double>(now_us_ - last_touch_us_);
  const double longest_ms =
      std::max(settings_.limits.lost_cap_ms, 1e-3 * kTouchesMissed * static_cast<double>(periodOf(rates_.touch_Hz)));
  const bool missed = touch_ && gap_ms > longest_ms;
  if (!missed && touch_ && static_cast<std::int16_t>(touch.sequence - touch_sequence_) <= 0) {
    refuse(LinkRefusal::late);
    return;
  }
  if (missed && counters_.lost == lost_at_touch_) ++counters_.lost;  // else its silence was counted
  lost_at_touch_ = counters_.lost;
  last_touch_us_ = now_us_;
  touch_ = touch;
  touch_sequence_ = touch.sequence;
  ++counters_.touches;
  out.touch_sent = now_ - std::chrono::microseconds(std::max<std::int64_t>(received.age_us, 0));
  out.touch_seen = out.touch_sent - fromSeconds(touch.age_s);
  out.touch = {
      .position_mm = touch.position_mm, .in_contact = touch.in_contact, .force_N = touch.force_N.value_or(0.0)};
}

}  // namespace fyd::protocol
