#include "core/protocol/link/link_touchpad_end.h"

#include <algorithm>
#include <cmath>

#include "core/protocol/link/message_budget.h"
#include "core/protocol/link_phase.h"

namespace fyd::protocol {
namespace {

using pipeline::LinkPhase;
using pipeline::RobotCommand;

constexpr LinkTime kPendingLife_us = 2'000'000;
constexpr LinkTime kSettling_us = 5'000;
constexpr int kFragmentsAtOnce = 2;
constexpr int kFarewells = 3;
constexpr LinkTime kMostBehindPeriods = 2;
// With a configured bit rate, a heartbeat is sent only once in so many touches.
constexpr LinkTime kTouchesPerBeatOnSlowLine = 10;

}  // namespace

LinkTouchpadEnd::LinkTouchpadEnd(const LinkParameters& parameters, const LinkKey& key, RandomSource random)
    : parameters_(parameters),
      key_(key),
      random_((prepareCryptography(), random)),
      cookies_(random),
      touch_workspace_(asOnTheWire(TouchpadHello{}.workspace)),
      touch_code_(*PositionCode::make(touch_workspace_)) {}

const TouchpadReception& LinkTouchpadEnd::handle(Bytes datagram, const Endpoint& from, Instant now,
                                                 const TouchpadAnswer& answer) {
  const std::uint64_t lost_before = counters_.lost;
  passTime(now);
  reception_.clear();
  outbox_.clear();
  reception_.was_lost = counters_.lost != lost_before;
  const LinkSorted sorted = sortDatagram(datagram);
  if (sorted.refusal != LinkRefusal::none) {
    refuse(sorted.refusal);
  } else if (sorted.kind == LinkKind::hello) {
    takeHello(datagram, from);
  } else if (sorted.kind == LinkKind::call) {
    takeCall(datagram, from, answer);
  } else if (sorted.kind == LinkKind::sealed) {
    takeSealed(datagram, from, answer);
  } else {
    refuse(LinkRefusal::kind);
  }
  for (const Datagram& reply : outbox_.view()) static_cast<void>(reception_.replies.push(reply));
  return reception_;
}

void LinkTouchpadEnd::passTime(Instant now) {
  now_ = now;
  now_us_ = time_.advance(now);
  if (pending_ && now_us_ - pending_->since_us > kPendingLife_us) pending_.reset();
  if (phase_ != LinkPhase::running || !connection_) return;
  const bool silent = connection_->silence_ms(now_us_) > connection_->lostLimit_ms(parameters_);
  // Heartbeats alone do not keep the link: a robot that sends no states for too long counts as lost.
  const double stateless_ms = 1e-3 * static_cast<double>(now_us_ - last_state_us_);
  if (!silent && stateless_ms <= std::max(parameters_.lost_cap_ms, kPeriodsWithinCap * connection_->period_ms()))
    return;
  phase_ = nextPhase(phase_, LinkEvent::silence);
  ++counters_.lost;
  images_.stop();
  any_state_ = false;  // its numbers may have gone round meanwhile; what is old is refused as replayed or not fresh
}

void LinkTouchpadEnd::takeSealed(Bytes datagram, const Endpoint& from, const TouchpadAnswer& answer) {
  if (datagram.size() <= kSealOverhead || datagram.size() > kMaximumLinkDatagram) {
    refuse(LinkRefusal::size);
    return;
  }
  const auto id = static_cast<std::uint16_t>(datagram[2] | (datagram[3] << 8));
  const bool present = connection_ && peer_ == from && connection_->id() == id;
  if (pending_ && pending_->from == from && pending_->connection.id() == id && !present) {
    takeConfirmation(datagram);
    return;
  }
  if (!connection_) {
    refuse(LinkRefusal::phase);
    return;
  }
  if (peer_ != from) {
    refuse(LinkRefusal::peer);
    return;
  }
  const LinkReceived received = connection_->receive(datagram, now_us_, parameters_);
  if (!received.ok()) {
    refuse(received.refusal);
    return;
  }
  takeMessage(received, answer);
}

void LinkTouchpadEnd::takeMessage(const LinkReceived& received, const TouchpadAnswer& answer) {
  if (received.message.type == LinkMessage::heartbeat) {
    if (received.clock_sampled) ++counters_.heartbeats;
    return;
  }
  if (phase_ == LinkPhase::closed) {
    refuse(LinkRefusal::phase);
    return;
  }
  switch (received.message.type) {
    case LinkMessage::state: takeState(received); break;
    case LinkMessage::command: takeCommand(received.message, answer); break;
    case LinkMessage::goodbye:
      if (const auto goodbye = decodeGoodbye(received.message); goodbye.ok()) {
        phase_ = nextPhase(phase_, LinkEvent::goodbye);
        images_.stop();
      } else {
        refuse(goodbye.refusal);
      }
      break;
    default: refuse(LinkRefusal::message);
  }
}

void LinkTouchpadEnd::takeState(const LinkReceived& received) {
  const auto decoded = decodeState(received.message, robot_code_);
  if (!decoded.ok()) {
    refuse(decoded.refusal);
    return;
  }
  const LinkState& state = decoded.value;
  last_state_us_ = now_us_;
  if (now_us_ - established_us_ < kSettling_us) {
    refuse(LinkRefusal::phase);
    return;
  }
  if (any_state_ && static_cast<std::int16_t>(state.sequence - state_sequence_) <= 0) {
    refuse(LinkRefusal::late);
    return;
  }
  any_state_ = true;
  state_sequence_ = state.sequence;
  phase_ = nextPhase(phase_, LinkEvent::state);
  ++counters_.states;
  reception_.state = state.robot;
  if (!robot_tells_force_) reception_.state->force_N = pipeline::RobotState{}.force_N;
  const Instant sent = now_ - std::chrono::microseconds(received.age_us);
  for (const LinkAcceleration& sample : state.accelerations) {
    const Instant taken = std::min(now_, sent - fromSeconds(sample.age_s));
    static_cast<void>(reception_.accelerations.push({.taken = taken, .acceleration_g = sample.acceleration_g}));
    ++counters_.samples;
  }
  if (motor_references_on_ && state.motor_reference) reception_.motor_reference = state.motor_reference;
}

void LinkTouchpadEnd::takeCommand(const LinkEnvelope& message, const TouchpadAnswer& answer) {
  const auto decoded = decodeCommand(message);
  if (!decoded.ok()) {
    refuse(decoded.refusal);
    return;
  }
  const LinkCommand& command = decoded.value;
  if (command.id == static_cast<std::uint16_t>(command_id_ + 1)) {
    command_id_ = command.id;
    ++counters_.commands;
    reception_.command = command.command;
    obey(command.command);
  } else if (command.id == command_id_ && counters_.commands > 0) {
    ++counters_.repeated_commands;
  } else {
    refuse(LinkRefusal::late);
    return;
  }
  outbox_.seal(connection_->sealer(), *peer_,
               [&](auto out) { return encodeLink(LinkCommandAck{.id = command.id}, now_us_, out); });
  if (command.command == RobotCommand::send_info_and_pause) sendInfo(answer);
}

void LinkTouchpadEnd::obey(RobotCommand command) {
  switch (command) {
    case RobotCommand::send_info_and_pause: phase_ = nextPhase(phase_, LinkEvent::pause); break;
    case RobotCommand::resume: phase_ = nextPhase(phase_, LinkEvent::resume); break;
    case RobotCommand::disconnect: phase_ = nextPhase(phase_, LinkEvent::goodbye); break;
    case RobotCommand::images_on: images_on_ = true; break;
    case RobotCommand::images_off:
      images_on_ = false;
      images_.stop();
      break;
    case RobotCommand::motor_reference_on: motor_references_on_ = true; break;
    case RobotCommand::motor_reference_off: motor_references_on_ = false; break;
    default: break;  // gains and algorithms are the pipeline's
  }
  last_state_us_ = now_us_;  // after a pause, the full time without states is allowed again
}

void LinkTouchpadEnd::sendInfo(const TouchpadAnswer& answer) {
  outbox_.seal(connection_->sealer(), *peer_, [&](auto out) {
    return encodeLink(LinkInfo{.k_vib = answer.info.k_vib,
                               .reference_ticks = answer.info.reference_ticks,
                               .board_text = answer.board_text},
                      now_us_, out);
  });
}

void LinkTouchpadEnd::sendTouch(const TouchpadAnswer& answer) {
  const auto& seen = answer.touch.seen;
  const Vec3& at = answer.touch.position_mm;
  LinkTouch touch{.sequence = ++touch_sequence_,
                  .age_s = toSeconds(now_ - std::min(now_, seen ? seen->taken : answer.taken)),
                  .position_mm = seen ? Vec3{seen->x_mm, seen->y_mm, at.z} : at,
                  .in_contact = answer.touch.in_contact};
  if (touch_fields_.force) touch.force_N = answer.touch.force_N;
  if (touch_fields_.indentation) touch.indentation_mm = answer.touch.in_contact ? -answer.touch.position_mm.z : 0.0;
  outbox_.seal(connection_->sealer(), *peer_, [&](auto out) { return encodeLink(touch, touch_code_, now_us_, out); });
  ++counters_.touches;
}

std::span<const Datagram> LinkTouchpadEnd::advance(Instant now, const TouchpadAnswer& answer) {
  passTime(now);
  outbox_.clear();
  if (!connection_ || phase_ == LinkPhase::closed) return {};
  const LinkTime period_us = periodOf(rates_.touch_Hz);
  if (now_us_ >= next_touch_us_) {
    sendTouch(answer);
    next_touch_us_ += period_us;
    if (now_us_ > next_touch_us_ + kMostBehindPeriods * period_us) next_touch_us_ = now_us_ + period_us;
    if (next_beat_us_ <= now_us_) next_beat_us_ = now_us_ + period_us / 2;
  }
  if (now_us_ >= next_beat_us_) {
    outbox_.seal(connection_->sealer(), *peer_,
                 [&](auto out) { return encodeLink(connection_->heartbeat(now_us_), now_us_, out); });
    next_beat_us_ = next_touch_us_ + period_us / 2;
    if (parameters_.flow_bit_per_s > 0.0) next_beat_us_ += (kTouchesPerBeatOnSlowLine - 1) * period_us;
  }
  // Not to a robot that is lost: what fills its line would keep it lost.
  const bool images = images_on_ && (phase_ == LinkPhase::running || phase_ == LinkPhase::paused);
  if (images && images_.begin(answer.image)) ++counters_.images;
  for (int i = 0; i < kFragmentsAtOnce && images && images_.busy(); ++i) {
    outbox_.seal(connection_->sealer(), *peer_, [&](auto out) { return encodeLink(images_.next(), now_us_, out); });
  }
  return outbox_.view();
}

std::span<const Datagram> LinkTouchpadEnd::farewell(Instant now) {
  passTime(now);
  outbox_.clear();
  if (!connection_ || phase_ == LinkPhase::closed) return {};
  for (int i = 0; i < kFarewells; ++i) {
    outbox_.seal(connection_->sealer(), *peer_, [&](auto out) { return encodeLink(LinkGoodbye{}, now_us_, out); });
  }
  phase_ = nextPhase(phase_, LinkEvent::goodbye);
  return outbox_.view();
}

LinkFigures LinkTouchpadEnd::figures(Instant /*now*/) const {
  LinkFigures out{.states = counters_.states,
                  .touches = counters_.touches,
                  .lost = counters_.lost,
                  .heartbeats = counters_.heartbeats};
  for (std::size_t i = 1; i < kLinkRefusalCount; ++i) {
    if (refusals_[i] == 0) continue;
    out.refused += refusals_[i];
    static_cast<void>(out.refusals.push({.reason = toString(static_cast<LinkRefusal>(i)), .count = refusals_[i]}));
  }
  if (!connection_) return out;
  out.silence_ms = connection_->silence_ms(now_us_);
  out.period_ms = connection_->period_ms();
  out.jitter_ms = connection_->jitter_ms();
  out.lost_limit_ms = connection_->lostLimit_ms(parameters_);
  out.loss_percent = connection_->loss_percent();
  out.round_trip_ms = 1e-3 * static_cast<double>(connection_->clock().newestRoundTrip_us());
  out.sample_delay_ms = 0.5 * out.round_trip_ms + out.period_ms + out.jitter_ms;
  out.clock_offset_ms = 1e-3 * static_cast<double>(connection_->clock().offset_us());
  return out;
}

}  // namespace fyd::protocol
