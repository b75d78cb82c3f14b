// Time within a session: the own clock, which never goes back, and the estimate of the other end's.
//
// Round trip and offset are those of the Network Time Protocol: for a heartbeat sent at s (other end's clock) that
// echoes e (own clock) after holding it for h, and arrives at n (own clock),
//   round trip = n − e − h,    offset = s − (n − round trip / 2),    |error of the offset| ≤ round trip / 2.
// The sample with the smallest round trip is kept; it ages by 100 µs a second (clocks drift), so that it is
// replaced in time. A sample that contradicts it (their intervals do not meet) means that a clock jumped: it is
// taken in its place.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "core/base/time.h"
#include "core/protocol/link/link_messages.h"

namespace fyd::protocol {

/// Of a whole number of messages a second.
[[nodiscard]] inline LinkTime periodOf(double rate_Hz) { return static_cast<LinkTime>(std::lround(1e6 / rate_Hz)); }
[[nodiscard]] inline LinkTime microseconds(Duration duration) {
  return static_cast<LinkTime>(std::chrono::duration_cast<std::chrono::microseconds>(duration).count());
}

[[nodiscard]] inline std::int64_t signedDifference(LinkTime a, LinkTime b) {
  return static_cast<std::int64_t>(a) - static_cast<std::int64_t>(b);
}

/// The caller's instants as a session's microseconds: when they go back, this time does not advance and then continues;
/// a forward jump counts as an hour at most, which is beyond every time-out and fits 48 bits.
class SteadyTime {
 public:
  LinkTime advance(Instant now) {
    if (started_ && now > last_) elapsed_ += std::min<Duration>(now - last_, kLongestStep);
    started_ = true;
    last_ = now;
    return microseconds();
  }
  [[nodiscard]] LinkTime microseconds() const {
    return kOrigin_us + static_cast<LinkTime>(std::chrono::duration_cast<std::chrono::microseconds>(elapsed_).count());
  }

 private:
  static constexpr LinkTime kOrigin_us = 1'000'000;  // what was taken shortly before the start has a time as well
  static constexpr Duration kLongestStep = std::chrono::hours(1);
  bool started_ = false;
  Instant last_{};
  Duration elapsed_{};
};

class PeerClock {
 public:
  /// @return the sample's round trip, µs; negative when the numbers are impossible
  std::int64_t sample(LinkTime now_us, LinkTime sent_us, LinkTime echo_us, std::uint32_t held_us) {
    std::int64_t round_trip = signedDifference(now_us, echo_us) - std::int64_t{held_us};
    if (round_trip < -kRounding_us) return -1;
    round_trip = std::max<std::int64_t>(round_trip, 0);
    const std::int64_t offset = signedOf(sent_us) - (signedOf(now_us) - round_trip / 2);
    const std::int64_t allowed = round_trip_us_ + ageing(now_us);
    const bool contradicts = known_ && std::abs(offset - offset_us_) > (round_trip + allowed) / 2 + kJump_us;
    if (!known_ || contradicts || round_trip <= allowed) {
      known_ = true;
      round_trip_us_ = round_trip;
      offset_us_ = offset;
      taken_us_ = now_us;
    }
    newest_round_trip_us_ = round_trip;
    return round_trip;
  }
  [[nodiscard]] bool known() const { return known_; }
  /// The other end's time less this end's, µs.
  [[nodiscard]] std::int64_t offset_us() const { return offset_us_; }
  /// How long before `now` (own clock) the instant `sent` of the other end's clock was, µs; negative: later.
  [[nodiscard]] std::int64_t age_us(LinkTime now_us, LinkTime sent_us) const {
    return signedOf(now_us) - (signedOf(sent_us) - offset_us_);
  }
  [[nodiscard]] std::int64_t bestRoundTrip_us() const { return round_trip_us_; }
  [[nodiscard]] std::int64_t newestRoundTrip_us() const { return newest_round_trip_us_; }

 private:
  static constexpr std::int64_t kRounding_us = 10;
  static constexpr std::int64_t kJump_us = 1'000;
  static std::int64_t signedOf(LinkTime t) { return static_cast<std::int64_t>(t); }
  [[nodiscard]] std::int64_t ageing(LinkTime now_us) const { return signedOf(now_us - taken_us_) / 10'000; }

  bool known_ = false;
  std::int64_t offset_us_ = 0;
  std::int64_t round_trip_us_ = 0;
  std::int64_t newest_round_trip_us_ = 0;
  LinkTime taken_us_ = 0;
};

}  // namespace fyd::protocol
