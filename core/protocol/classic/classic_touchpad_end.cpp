#include "core/protocol/classic/classic_touchpad_end.h"

#include <algorithm>
#include <cmath>

namespace fyd::protocol {
namespace {

using pipeline::LinkPhase;
using pipeline::RobotCommand;

constexpr double kClassicLostFloor_ms = 20.0;
constexpr double kClassicSmoothing = 1.0 / 16.0;
constexpr double kClassicJitterDeviations = 4.0;
constexpr std::size_t kImageChunk = 1'400;  // bytes: a datagram that fits one Ethernet frame
constexpr std::string_view kNoBoardText = "-";

static_assert(4 + (kClassicMaximumImage + kImageChunk - 1) / kImageChunk + 1 <= TouchpadReception::kMaximumReplies,
              "touch, info triple, image length and the image's datagrams fit one cycle's replies");

}  // namespace

ClassicTouchpadEnd::ClassicTouchpadEnd(const LinkParameters& parameters) : parameters_(parameters) {}

const TouchpadReception& ClassicTouchpadEnd::handle(Bytes datagram, const Endpoint& from, Instant now,
                                                    const TouchpadAnswer& answer) {
  const std::uint64_t lost_before = counters_.lost;
  advance(now);
  reception_.clear();
  reception_.was_lost = counters_.lost != lost_before;

  if (isAck(datagram)) {
    handleAck(from, now, answer);
  } else if (peer_ == from) {
    handlePeer(datagram, now, answer);
  } else {
    handleStranger(datagram, from, now, answer);
  }
  return reception_;
}

void ClassicTouchpadEnd::advance(Instant now) {
  if (phase_ != LinkPhase::running || !last_state_ || now - *last_state_ <= lostLimit()) return;
  phase_ = nextPhase(phase_, LinkEvent::silence);
  ++counters_.lost;
}

Duration ClassicTouchpadEnd::lostLimit() const {
  const double wanted_ms = std::max(kClassicLostFloor_ms, 3.0 * period_ms_ + jitterMs());
  return fromSeconds(1e-3 * std::min(wanted_ms, std::max(kClassicLostFloor_ms, parameters_.lost_cap_ms)));
}

double ClassicTouchpadEnd::jitterMs() const { return kClassicJitterDeviations * deviation_ms_; }

LinkFigures ClassicTouchpadEnd::figures(Instant now) const {
  LinkFigures out{.states = counters_.states,
                  .touches = counters_.touches,
                  .refused = counters_.refused(),
                  .lost = counters_.lost,
                  .lost_limit_ms = toMilliseconds(lostLimit())};
  if (peer_) out.silence_ms = toMilliseconds(silence(now));
  if (period_ms_ > 0.0) {
    out.period_ms = period_ms_;
    out.jitter_ms = jitterMs();
  }
  const auto add = [&out](std::string_view reason, std::uint64_t count) {
    if (count > 0) static_cast<void>(out.refusals.push({.reason = reason, .count = count}));
  };
  add(sentence("other address"), counters_.wrong_peer);
  add(sentence("a second robot"), counters_.second_robot);
  add(sentence("before a handshake"), counters_.before_handshake);
  add(sentence("out of turn"), counters_.out_of_turn);
  for (std::size_t i = 1; i < kClassicRefusalCount; ++i) {
    add(toString(static_cast<ClassicRefusal>(i)), counters_.refusals[i]);
  }
  return out;
}

Duration ClassicTouchpadEnd::silence(Instant now) const { return peer_ ? now - last_heard_ : Duration::zero(); }

bool ClassicTouchpadEnd::mayTakeOver(const Endpoint& from, Instant now) const {
  if (!peer_ || *peer_ == from || phase_ == LinkPhase::closed) return true;
  return silence(now) >= fromSeconds(parameters_.takeover_silence_s);
}

void ClassicTouchpadEnd::handleAck(const Endpoint& from, Instant now, const TouchpadAnswer& answer) {
  if (!mayTakeOver(from, now)) {
    ++counters_.second_robot;
    return;
  }
  if (farewell_peer_ == from) farewell_peer_.reset();
  if (phase_ == LinkPhase::closed && peer_ != from) {
    farewell_peer_ = peer_;
    farewell_until_ = closed_at_ + fromSeconds(parameters_.closing_s);
  }
  peer_ = from;
  phase_ = nextPhase(phase_, LinkEvent::handshake);
  last_heard_ = now;
  last_state_.reset();
  period_ms_ = 0.0;
  deviation_ms_ = 0.0;
  images_on_ = false;
  motor_references_on_ = false;
  robot_ = {};
  ++counters_.acks;
  reception_.session_started = true;
  replyInfo(answer);
}

void ClassicTouchpadEnd::handleStranger(Bytes datagram, const Endpoint& from, Instant now,
                                        const TouchpadAnswer& answer) {
  if (farewell_peer_ == from && now < farewell_until_ && (looksLikeState(datagram) || decodeState(datagram).ok())) {
    ++counters_.farewell_states;
    replyTouch(from, answer);
    return;
  }
  ++(peer_ ? counters_.wrong_peer : counters_.before_handshake);
}

void ClassicTouchpadEnd::handlePeer(Bytes datagram, Instant now, const TouchpadAnswer& answer) {
  const Decoded<ClassicState> decoded = decodeState(datagram);
  if (decoded.ok() || looksLikeState(datagram)) {
    ++counters_.states;
    if (decoded.ok()) {
      last_heard_ = now;
      measure(now);
      phase_ = nextPhase(phase_, LinkEvent::state);
      useState(decoded.value, now);
    } else {  // answered, and for the rest as if it had not come: nothing but such states is a lost link
      ++counters_.states_damaged;
      ++counters_.refusals[static_cast<std::size_t>(decoded.refusal)];
    }
    replyTouch(*peer_, answer);
    if (decoded.value.command == RobotCommand::send_info_and_pause) replyInfo(answer);
    if (images_on_) replyImage(answer);
    return;
  }
  const Decoded<pipeline::RobotMotorReference> reference = decodeMotorReference(datagram);
  if (!reference.ok()) {
    ++counters_.unrecognised;
    const ClassicRefusal why = datagram.size() == kClassicMotorReferenceSize ? reference.refusal : decoded.refusal;
    ++counters_.refusals[static_cast<std::size_t>(why)];
  } else if (!motor_references_on_ || phase_ == LinkPhase::closed) {
    ++counters_.out_of_turn;
  } else {
    last_heard_ = now;
    ++counters_.motor_references;
    reception_.motor_reference = reference.value;
  }
}

void ClassicTouchpadEnd::useState(const ClassicState& state, Instant now) {
  if (!state.stiffness_known) ++counters_.states_cut;
  if (phase_ == LinkPhase::closed) return;  // its sender said goodbye: answered, no longer used
  const double last_stiffness = robot_.stiffness_N_per_mm;
  robot_ = state.robot;
  if (!state.stiffness_known) robot_.stiffness_N_per_mm = last_stiffness;
  reception_.state = robot_;
  static_cast<void>(reception_.accelerations.push({.taken = now, .acceleration_g = state.acceleration_g}));
  reception_.command = state.command;
  obey(state.command, now);
}

void ClassicTouchpadEnd::obey(RobotCommand command, Instant now) {
  switch (command) {
    case RobotCommand::send_info_and_pause: phase_ = nextPhase(phase_, LinkEvent::pause); break;
    case RobotCommand::resume: phase_ = nextPhase(phase_, LinkEvent::resume); break;
    case RobotCommand::images_on: images_on_ = parameters_.classic_images; break;
    case RobotCommand::images_off: images_on_ = false; break;
    case RobotCommand::motor_reference_on: motor_references_on_ = true; break;
    case RobotCommand::motor_reference_off: motor_references_on_ = false; break;
    case RobotCommand::disconnect:
      phase_ = nextPhase(phase_, LinkEvent::goodbye);
      closed_at_ = now;
      break;
    default: break;  // gains and algorithms are the pipeline's
  }
}

void ClassicTouchpadEnd::measure(Instant now) {
  if (last_state_ && now > *last_state_) {
    const double interval_ms = std::min(toMilliseconds(now - *last_state_), parameters_.lost_cap_ms);
    if (period_ms_ == 0.0) {
      period_ms_ = interval_ms;
    } else {
      deviation_ms_ += kClassicSmoothing * (std::abs(interval_ms - period_ms_) - deviation_ms_);
      period_ms_ += kClassicSmoothing * (interval_ms - period_ms_);
    }
  }
  last_state_ = now;
}

void ClassicTouchpadEnd::reply(Bytes bytes, const Endpoint& to) {
  const bool stored = reception_.replies.push({.bytes = bytes, .to = to});
  static_cast<void>(stored);  // sized for the longest cycle, see the assertion above
}

void ClassicTouchpadEnd::replyTouch(const Endpoint& to, const TouchpadAnswer& answer) {
  touch_ = encodeTouch(answer.touch);
  reply(touch_, to);
  ++counters_.touches;
}

void ClassicTouchpadEnd::replyInfo(const TouchpadAnswer& answer) {
  std::string_view text = answer.board_text.empty() ? kNoBoardText : answer.board_text;
  text = text.substr(0, kClassicMaximumBoardText);
  info_length_ = encodeInfoLength(text.size());
  info_values_ = encodeInfoValues(answer.info);
  reply(info_length_, *peer_);
  reply({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, *peer_);
  reply(info_values_, *peer_);
}

void ClassicTouchpadEnd::replyImage(const TouchpadAnswer& answer) {
  Bytes rest = answer.image.size() <= kClassicMaximumImage ? answer.image : Bytes{};
  reception_.image_used = true;
  image_length_ = encodeImageLength(rest.size());
  reply(image_length_, *peer_);
  if (!rest.empty()) ++counters_.images;
  while (!rest.empty()) {
    const std::size_t size = std::min(rest.size(), kImageChunk);
    reply(rest.first(size), *peer_);
    rest = rest.subspan(size);
  }
}

}  // namespace fyd::protocol
