#include "core/protocol/link/link_robot_end.h"

#include <algorithm>
#include <cmath>

namespace fyd::protocol {
namespace {

using pipeline::RobotCommand;

constexpr int kRobotFarewells = 3;
constexpr LinkTime kBetweenFarewells_us = 5'000;
constexpr LinkTime kShortestCommandRetry_us = 20'000;
constexpr LinkTime kMostTouchBehindPeriods = 2;

}  // namespace

LinkRobotEnd::LinkRobotEnd(const LinkRobotSettings& settings, const LinkKey& key, const Endpoint& touchpad,
                           RandomSource random)
    : settings_(settings), key_(key), touchpad_(touchpad), random_(random) {
  prepareCryptography();
  settings_.workspace = asOnTheWire(settings.workspace);
  // A workspace that cannot be coded is replaced by the default; settings are the program's, not the network's.
  if (!PositionCode::make(settings_.workspace)) settings_.workspace = asOnTheWire(RobotHello{}.workspace);
  own_code_ = *PositionCode::make(settings_.workspace);
}

void LinkRobotEnd::refuse(LinkRefusal refusal) {
  ++refusals_[static_cast<std::size_t>(refusal)];
  ++counters_.refused;
}

bool LinkRobotEnd::command(RobotCommand command) { return command == RobotCommand::none || commands_.push(command); }

std::string_view LinkRobotEnd::problem() const {
  if (phase_ != RobotPhase::handshake) return "";
  if (status_ != CallStatus::accepted) return toString(status_);
  return caller_ ? sentence("the touchpad does not answer the call") : sentence("no touchpad with this key answered");
}

void LinkRobotEnd::startOver() {
  connection_.reset();
  caller_.reset();
  greeted_ = false;
  outstanding_ = RobotCommand::none;
  samples_.clear();
  motor_references_on_ = false;
  farewells_left_ = 0;
}

void LinkRobotEnd::passTime(Instant now) {
  now_us_ = time_.advance(now);
  if (!connection_) return;
  const double silence_ms = connection_->silence_ms(now_us_);
  if (phase_ == RobotPhase::running && silence_ms > connection_->lostLimit_ms(settings_.limits)) {
    phase_ = nextPhase(phase_, RobotEvent::silence);
    ++counters_.lost;
  }
  const Duration patience = phase_ == RobotPhase::paused ? settings_.give_up_paused : settings_.give_up;
  if (silence_ms <= toMilliseconds(patience)) return;
  phase_ = nextPhase(phase_, RobotEvent::give_up);
  commands_.clear();  // what was meant for this session must not happen in the next
  startOver();
}

std::span<const Datagram> LinkRobotEnd::tick(Instant now, const RobotReport& report) {
  outbox_.clear();
  passTime(now);
  if (phase_ == RobotPhase::handshake) {
    if (!commands_.empty() && commands_[0] == RobotCommand::disconnect) {
      phase_ = nextPhase(phase_, RobotEvent::leave);
      startOver();
      return {};
    }
    tickHandshake();
  } else if (phase_ == RobotPhase::closing) {
    sendFarewell();
  } else if (connection_ && phase_ != RobotPhase::closed) {
    collect(now, report);
    sendCommand();
    if (now_us_ >= next_state_us_) sendState(report);
    if (now_us_ >= next_beat_us_) {
      outbox_.seal(connection_->sealer(), touchpad_,
                   [&](auto out) { return encodeLink(connection_->heartbeat(now_us_), now_us_, out); });
      next_beat_us_ = next_state_us_ - periodOf(rates_.state_Hz) / 2;
      if (next_beat_us_ <= now_us_) next_beat_us_ += periodOf(rates_.state_Hz);
    }
  }
  return outbox_.view();
}

void LinkRobotEnd::tickHandshake() {
  if (caller_ && now_us_ - called_us_ > microseconds(settings_.call_life)) startOver();
  if (now_us_ < next_try_us_) return;
  next_try_us_ = now_us_ + microseconds(settings_.retry);
  if (caller_) {
    outbox_.add(Bytes(call_).first(call_size_), touchpad_);
    return;
  }
  if (!greeted_) random_(nonce_);
  greeted_ = true;
  ++counters_.acks;
  outbox_.add(makeHello(key_, nonce_), touchpad_);
}

void LinkRobotEnd::collect(Instant now, const RobotReport& report) {
  const Instant taken = std::min(now, report.acceleration_taken.value_or(now));
  const LinkTime age_us = std::min(now_us_, microseconds(now - taken));
  const LinkTime taken_us = now_us_ - age_us;
  if (last_sample_us_ && taken_us <= *last_sample_us_) return;  // the sensor has nothing new
  last_sample_us_ = taken_us;
  if (samples_.full()) {
    std::copy(samples_.begin() + 1, samples_.end(), samples_.items.begin());
    --samples_.count;
    ++link_counters_.samples_dropped;
  }
  static_cast<void>(samples_.push({.taken_us = taken_us, .acceleration_g = report.acceleration_g}));
}

void LinkRobotEnd::sendState(const RobotReport& report) {
  LinkState state{.sequence = ++state_sequence_, .robot = report.robot};
  if (motor_references_on_) {
    state.motor_reference = report.motor_reference;
    ++counters_.motor_references;
  }
  for (const Sample& sample : samples_) {
    static_cast<void>(state.accelerations.push(
        {.age_s = 1e-6 * static_cast<double>(now_us_ - sample.taken_us), .acceleration_g = sample.acceleration_g}));
  }
  samples_.clear();
  outbox_.seal(connection_->sealer(), touchpad_, [&](auto out) { return encodeLink(state, own_code_, now_us_, out); });
  ++counters_.states;
  const LinkTime period_us = periodOf(rates_.state_Hz);
  next_state_us_ += period_us;
  if (now_us_ > next_state_us_ + kMostTouchBehindPeriods * period_us) next_state_us_ = now_us_ + period_us;
}

void LinkRobotEnd::nextCommand() {
  outstanding_ = commands_[0];
  std::copy(commands_.begin() + 1, commands_.end(), commands_.items.begin());
  --commands_.count;
  next_command_us_ = now_us_;
  if (outstanding_ != RobotCommand::disconnect) {
    ++command_id_;
    return;
  }
  outstanding_ = RobotCommand::none;
  phase_ = nextPhase(phase_, RobotEvent::leave);
  farewells_left_ = kRobotFarewells;
  next_farewell_us_ = now_us_;
  sendFarewell();
}

void LinkRobotEnd::sendCommand() {
  const bool is_new = outstanding_ == RobotCommand::none && !commands_.empty();
  if (is_new) nextCommand();
  if (outstanding_ == RobotCommand::none || now_us_ < next_command_us_) return;
  if (!is_new) ++link_counters_.command_repeats;
  const auto round_trip_us = static_cast<LinkTime>(connection_->clock().newestRoundTrip_us());
  next_command_us_ = now_us_ + std::max(kShortestCommandRetry_us, 2 * round_trip_us);
  outbox_.seal(connection_->sealer(), touchpad_, [&](auto out) {
    return encodeLink(LinkCommand{.id = command_id_, .command = outstanding_}, now_us_, out);
  });
}

void LinkRobotEnd::sendFarewell() {
  if (farewells_left_ > 0 && now_us_ >= next_farewell_us_) {
    outbox_.seal(connection_->sealer(), touchpad_, [&](auto out) {
      return encodeLink(LinkGoodbye{.reason = GoodbyeReason::operator_left}, now_us_, out);
    });
    --farewells_left_;
    next_farewell_us_ = now_us_ + kBetweenFarewells_us;
  }
  if (farewells_left_ == 0) phase_ = nextPhase(phase_, RobotEvent::said);
}

}  // namespace fyd::protocol
