#include "core/protocol/link/link_connection.h"

#include <algorithm>
#include <cmath>

namespace fyd::protocol {
namespace {

constexpr double kLostFloor_ms = 20.0;
constexpr double kSmoothing = 1.0 / 16.0;
constexpr double kJitterDeviations = 4.0;
constexpr LinkTime kLossWindow_us = 1'000'000;
constexpr std::int64_t kFutureSlack_us = 1'000;  // clocks read a moment apart

/// A heartbeat, or an answer, whose round trip is longer does not measure the clocks: it may have been delayed.
std::int64_t longestRoundTrip_us(const LinkParameters& parameters) {
  return static_cast<std::int64_t>(2e3 * parameters.freshness_ms);
}

}  // namespace

LinkReceived LinkConnection::receive(Bytes datagram, LinkTime now_us, const LinkParameters& parameters) {
  const Opened opened = opener_.open(datagram, plain_);
  if (!opened.ok()) return {.refusal = opened.refusal};
  ++window_taken_;
  const auto envelope = decodeEnvelope(opened.message);
  if (!envelope.ok()) return {.refusal = envelope.refusal};
  LinkReceived out{.message = envelope.value};
  out.refusal = judge(out, now_us, parameters);
  if (out.ok()) measure(now_us, out.message.sent_us);
  return out;
}

LinkRefusal LinkConnection::judge(LinkReceived& received, LinkTime now_us, const LinkParameters& parameters) {
  const LinkEnvelope& message = received.message;
  const auto limit_us = static_cast<std::int64_t>(1e3 * parameters.freshness_ms);
  if (message.type == LinkMessage::heartbeat) {
    const auto beat = decodeHeartbeat(message);
    if (!beat.ok()) return beat.refusal;
    const std::int64_t round_trip =
        signedDifference(now_us, beat.value.echo_us) - static_cast<std::int64_t>(beat.value.held_us);
    if (round_trip <= longestRoundTrip_us(parameters)) {
      received.clock_sampled = clock_.sample(now_us, message.sent_us, beat.value.echo_us, beat.value.held_us) >= 0;
    }
  }
  if (!clock_.known()) return LinkRefusal::phase;
  received.age_us = clock_.age_us(now_us, message.sent_us);
  if (received.clock_sampled) return LinkRefusal::none;
  const std::int64_t slack_us = clock_.bestRoundTrip_us() / 2 + kFutureSlack_us;
  if (received.age_us > limit_us + slack_us) return LinkRefusal::stale;
  if (received.age_us < -slack_us) return LinkRefusal::future;
  return LinkRefusal::none;
}

void LinkConnection::learnClock(LinkTime now_us, LinkTime sent_us, LinkTime echo_us, std::uint32_t held_us,
                                const LinkParameters& parameters) {
  if (signedDifference(now_us, echo_us) - std::int64_t{held_us} <= longestRoundTrip_us(parameters)) {
    static_cast<void>(clock_.sample(now_us, sent_us, echo_us, held_us));
  }
  newest_sent_us_ = sent_us;
  newest_heard_us_ = now_us;
}

LinkHeartbeat LinkConnection::heartbeat(LinkTime now_us) const {
  constexpr LinkTime kLongest = 0xFFFF'FFFF;
  return {.echo_us = newest_sent_us_,
          .held_us = static_cast<std::uint32_t>(std::min(now_us - newest_heard_us_, kLongest))};
}

void LinkConnection::measure(LinkTime now_us, LinkTime sent_us) {
  heard_us_ = now_us;
  if (sent_us >= newest_sent_us_) {
    newest_sent_us_ = sent_us;
    newest_heard_us_ = now_us;
  }
  const double transit_ms = 1e-3 * static_cast<double>(signedDifference(now_us, sent_us));
  const double error_ms = transit_ms - transit_ms_;
  if (!moving_ || std::abs(error_ms) > 1e3) {  // the first, or a clock jumped
    transit_ms_ = transit_ms;
    moving_ = true;
  } else {
    deviation_ms_ += kSmoothing * (std::abs(error_ms) - deviation_ms_);
    transit_ms_ += kSmoothing * error_ms;
  }
  if (now_us - window_began_us_ < kLossWindow_us) return;
  const std::uint64_t next = opener_.window().next();
  const auto expected = static_cast<double>(next - window_first_);
  const auto taken = static_cast<double>(window_taken_);
  loss_percent_ = expected > 0.0 ? std::clamp(100.0 * (1.0 - taken / expected), 0.0, 100.0) : 0.0;
  window_first_ = next;
  window_taken_ = 0;
  window_began_us_ = now_us;
}

double LinkConnection::jitter_ms() const { return kJitterDeviations * deviation_ms_; }

double LinkConnection::lostLimit_ms(const LinkParameters& parameters) const {
  const double wanted_ms = std::max(kLostFloor_ms, 3.0 * period_ms_ + jitter_ms());
  return std::min(wanted_ms, std::max(kLostFloor_ms, parameters.lost_cap_ms));
}

}  // namespace fyd::protocol
