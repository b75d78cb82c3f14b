// The connection between the two ends of FYD Link while a session runs, as either end sees it: it opens sealed datagrams,
// judges their freshness, measures clocks, jitter and loss, and decides when the other end counts as lost.
//
// Freshness: a message older than the limit (by the offset of the clocks, whose error is at most half the best round
// trip) or from the future is refused. A heartbeat may prove its freshness by its echo instead: its round trip is at
// most twice the limit. Until the first heartbeat nothing else is taken.
//
// Lost: nothing fresh heard for max(20 ms, 3 · period + jitter), at most `lost_cap_ms`. Period is the negotiated one,
// jitter four times the smoothed mean deviation of the time under way.
#pragma once

#include <cstdint>

#include "core/protocol/link/link_clock.h"
#include "core/protocol/link/link_codec.h"
#include "core/protocol/link/secure_channel.h"
#include "core/protocol/link_parameters.h"

namespace fyd::protocol {

struct LinkReceived {
  LinkEnvelope message;  ///< points into the connection's buffer until the next call
  std::int64_t age_us = 0;
  bool clock_sampled = false;  ///< a heartbeat whose echo measured the round trip
  LinkRefusal refusal = LinkRefusal::none;
  [[nodiscard]] bool ok() const { return refusal == LinkRefusal::none; }
};

class LinkConnection {
 public:
  LinkConnection() = default;
  /// @param period_ms between two messages of the other end, as negotiated
  LinkConnection(const SecretBytes<32>& send_key, const SecretBytes<32>& receive_key, std::uint16_t session,
                 double period_ms, LinkTime now_us)
      : sealer_(send_key, session),
        opener_(receive_key, session),
        session_(session),
        period_ms_(period_ms),
        heard_us_(now_us),
        window_began_us_(now_us) {}

  /// Opens a datagram and judges it. A heartbeat is taken in here as well.
  [[nodiscard]] LinkReceived receive(Bytes datagram, LinkTime now_us, const LinkParameters& parameters);
  /// Takes the other end's clock from the handshake, unless its round trip is longer than a heartbeat's may be (the
  /// first heartbeat gives it then).
  void learnClock(LinkTime now_us, LinkTime sent_us, LinkTime echo_us, std::uint32_t held_us,
                  const LinkParameters& parameters);
  /// The next heartbeat to send.
  [[nodiscard]] LinkHeartbeat heartbeat(LinkTime now_us) const;

  [[nodiscard]] Sealer& sealer() { return sealer_; }
  [[nodiscard]] std::uint16_t id() const { return session_; }
  [[nodiscard]] const PeerClock& clock() const { return clock_; }
  [[nodiscard]] double lostLimit_ms(const LinkParameters& parameters) const;
  [[nodiscard]] double silence_ms(LinkTime now_us) const { return 1e-3 * static_cast<double>(now_us - heard_us_); }
  [[nodiscard]] double jitter_ms() const;
  [[nodiscard]] double period_ms() const { return period_ms_; }
  /// Share of the other end's datagrams that did not arrive, over the last second, %.
  [[nodiscard]] double loss_percent() const { return loss_percent_; }

 private:
  /// Also fills in how old it is, and whether it measured.
  [[nodiscard]] LinkRefusal judge(LinkReceived& received, LinkTime now_us, const LinkParameters& parameters);
  void measure(LinkTime now_us, LinkTime sent_us);

  Sealer sealer_;
  Opener opener_;
  std::uint16_t session_ = 0;
  PeerClock clock_;
  double period_ms_ = 10.0;
  LinkTime heard_us_ = 0;
  LinkTime newest_sent_us_ = 0;   // of the other end's clock, to be echoed
  LinkTime newest_heard_us_ = 0;  // when that was
  bool moving_ = false;           // transit_ms_ is known
  double transit_ms_ = 0.0;
  double deviation_ms_ = 0.0;
  LinkTime window_began_us_ = 0;
  std::uint64_t window_first_ = 0;
  std::uint64_t window_taken_ = 0;
  double loss_percent_ = 0.0;
  std::array<std::uint8_t, kMaximumLinkDatagram> plain_{};
};

}  // namespace fyd::protocol
