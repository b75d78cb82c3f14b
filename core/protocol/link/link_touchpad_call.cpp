// The touchpad's side of FYD Link: how a session begins.
#include <algorithm>
#include <cmath>

#include "core/protocol/link/link_touchpad_end.h"
#include "core/protocol/link/message_budget.h"
#include "core/protocol/link_phase.h"

namespace fyd::protocol {
namespace {

using pipeline::LinkPhase;

}  // namespace

void LinkTouchpadEnd::takeHello(Bytes datagram, const Endpoint& from) {
  HelloNonce nonce{};
  if (const LinkRefusal refusal = readHello(key_, datagram, nonce); refusal != LinkRefusal::none) {
    refuse(refusal);
    return;
  }
  ++counters_.hellos;
  outbox_.add(makeChallenge(key_, nonce, cookies_.make(from, now_us_)), from);
}

bool LinkTouchpadEnd::seenBefore(const PublicKey& caller) const {
  const auto seen = std::span(callers_).first(std::min(next_caller_, callers_.size()));
  return std::ranges::find(seen, caller) != seen.end();
}

bool LinkTouchpadEnd::mayTakeOver(const Endpoint& from) const {
  if (!connection_ || peer_ == from || phase_ == LinkPhase::closed) return true;
  return connection_->silence_ms(now_us_) >= 1e3 * parameters_.takeover_silence_s;
}

void LinkTouchpadEnd::takeCall(Bytes datagram, const Endpoint& from, const TouchpadAnswer& answer) {
  if (datagram.size() < kCallHeader + kNoiseOverhead || datagram.size() > kMaximumLinkDatagram) {
    refuse(LinkRefusal::size);
    return;
  }
  if (!cookies_.good(datagram.subspan(2, sizeof(Cookie)), from, now_us_)) {
    refuse(LinkRefusal::cookie);
    return;
  }
  PublicKey caller{};
  std::ranges::copy(datagram.subspan(kCallHeader, caller.size()), caller.begin());
  const bool repeated = seenBefore(caller);
  if (repeated && !(pending_ && pending_->caller == caller && pending_->from == from)) {
    refuse(LinkRefusal::repeated);
    return;
  }
  Callee callee(key_, datagram);
  std::array<std::uint8_t, kMaximumLinkDatagram> payload{};
  const auto opened = callee.read(datagram, payload);
  if (!opened) {
    refuse(LinkRefusal::key);
    return;
  }
  ++counters_.calls;
  if (repeated) {
    outbox_.add(Bytes(pending_->answer).first(pending_->answer_size), from);
    return;
  }
  const auto hello = decodeRobotHello(*opened);
  if (!hello.ok()) {
    refuse(hello.refusal);
    return;
  }
  callers_[next_caller_++ % callers_.size()] = caller;
  answerCall(callee, hello.value, from, caller, answer);
}

Rates LinkTouchpadEnd::grant(const Rates& wished) const {
  const double slowest_Hz = std::min(1e3 * kPeriodsWithinCap / parameters_.lost_cap_ms, 1e3);
  const double state_Hz = std::max(slowest_Hz, std::min(wished.state_Hz, parameters_.state_rate_Hz));
  double touch_Hz = std::min(wished.touch_Hz, parameters_.touch_rate_Hz);
  if (parameters_.flow_bit_per_s > 0.0) {
    const MessageBudget smallest = fitTouch(touch_code_, 0.0, 0.0, {});
    touch_Hz = std::min(touch_Hz, parameters_.flow_bit_per_s / smallest.datagram_bits);
  }
  return {.state_Hz = std::ceil(state_Hz), .touch_Hz = std::max(1.0, std::floor(touch_Hz))};
}

void LinkTouchpadEnd::answerCall(Callee& callee, const RobotHello& hello, const Endpoint& from, const PublicKey& caller,
                                 const TouchpadAnswer& answer) {
  const bool accepted = mayTakeOver(from);
  if (!accepted) refuse(LinkRefusal::second_robot);
  const TouchpadHello own{.status = accepted ? CallStatus::accepted : CallStatus::second_robot,
                          .sent_us = now_us_,
                          .echo_us = hello.sent_us,
                          .rates = grant(hello.rates),
                          .workspace = touch_workspace_,
                          .capabilities = static_cast<std::uint32_t>(Capability::images) |
                                          static_cast<std::uint32_t>(Capability::motor_reference) |
                                          static_cast<std::uint32_t>(Capability::force),
                          .k_vib = answer.info.k_vib,
                          .reference_ticks = answer.info.reference_ticks,
                          .board_text = answer.board_text};
  std::array<std::uint8_t, kMaximumLinkMessage> payload{};
  const std::size_t size = encodeHello(own, payload);
  const std::span<std::uint8_t> packet = outbox_.next();
  const std::size_t whole = callee.write(Bytes(payload).first(size), random_, packet);
  if (whole == 0) {
    refuse(LinkRefusal::key);  // the public key is invalid
    return;
  }
  if (accepted) {
    const SessionKeys keys = callee.keys();
    pending_.emplace(Pending{.connection = LinkConnection(keys.from_responder, keys.from_initiator, sessionOf(keys),
                                                          1e3 / own.rates.state_Hz, now_us_),
                             .from = from,
                             .caller = caller,
                             .rates = own.rates,
                             .tells_force = (hello.capabilities & static_cast<std::uint32_t>(Capability::force)) != 0,
                             .robot_code = *PositionCode::make(hello.workspace),
                             .robot_text = ShortText(hello.text),
                             .since_us = now_us_,
                             .answer_size = whole});
    std::copy_n(packet.begin(), whole, pending_->answer.begin());
  }
  outbox_.keep(whole, from);
}

void LinkTouchpadEnd::takeConfirmation(Bytes datagram) {
  const LinkReceived received = pending_->connection.receive(datagram, now_us_, parameters_);
  if (!received.ok()) {
    refuse(received.refusal);
  } else if (!mayTakeOver(pending_->from)) {  // the other robot came back meanwhile
    refuse(LinkRefusal::second_robot);
  } else {
    if (received.clock_sampled) ++counters_.heartbeats;
    establish();
  }
}

void LinkTouchpadEnd::establish() {
  connection_ = pending_->connection;
  peer_ = pending_->from;
  rates_ = pending_->rates;
  robot_tells_force_ = pending_->tells_force;
  robot_code_ = pending_->robot_code;
  robot_text_ = pending_->robot_text;
  pending_.reset();
  touch_fields_ = {};
  if (parameters_.flow_bit_per_s > 0.0) {
    touch_fields_ = fitTouch(touch_code_, parameters_.flow_bit_per_s, 1.0 / rates_.touch_Hz, {}).fields;
  }
  phase_ = nextPhase(phase_, LinkEvent::handshake);
  established_us_ = now_us_;
  last_state_us_ = now_us_;
  next_touch_us_ = now_us_;
  next_beat_us_ = now_us_;
  touch_sequence_ = 0;
  any_state_ = false;
  command_id_ = 0;
  images_on_ = false;
  motor_references_on_ = false;
  images_.stop();
  ++counters_.sessions;
  reception_.session_started = true;
}

}  // namespace fyd::protocol
