// The touchpad's side of FYD Link.
//
// Calls. A hello with the right MAC is answered by a challenge, and nothing of it is kept. A call with a good cookie,
// not seen before and authentic, is answered; the session it offers stays pending for 2 s beside the present one and
// takes its place only with the robot's first heartbeat under the new keys. So a replayed call ends no session, and
// the work of X25519 is done for holders of the key alone. A repeated call gets the same answer again.
//
// Peer. A new session may replace the present one when it comes from the same address, when the robot said goodbye,
// or when it was silent for `takeover_silence_s`; any other call is answered "another robot is served". Sealed
// datagrams are taken from the session's address only.
//
// Running. Touches go out at the negotiated rate, heartbeats half-way between them; commands are acknowledged once
// taken, a repeated one is acknowledged again and not taken twice. After a lost link the session lives on: what is
// heard then makes the phase running again (the safety states latch). The phase is "waiting" for the first 5 ms of a
// session at least, so that a caller that polls it notices the new robot.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/protocol/link/image_transfer.h"
#include "core/protocol/link/link_connection.h"
#include "core/protocol/link/link_handshake.h"
#include "core/protocol/link/outbox.h"
#include "core/protocol/touchpad_end.h"

namespace fyd::protocol {

/// What happened so far, beside the refusals.
struct LinkTouchpadCounters {
  std::uint64_t hellos = 0;
  std::uint64_t calls = 0;     ///< good ones, repeated ones included
  std::uint64_t sessions = 0;  ///< established
  std::uint64_t states = 0;
  std::uint64_t samples = 0;
  std::uint64_t commands = 0;
  std::uint64_t repeated_commands = 0;
  std::uint64_t heartbeats = 0;
  std::uint64_t touches = 0;
  std::uint64_t images = 0;
  std::uint64_t lost = 0;
};

class LinkTouchpadEnd final : public TouchpadEnd {
 public:
  LinkTouchpadEnd(const LinkParameters& parameters, const LinkKey& key, RandomSource random = systemRandom);
  void configure(const LinkParameters& parameters) { parameters_ = parameters; }

  [[nodiscard]] std::string_view name() const override { return sentence("FYD Link, sealed"); }
  [[nodiscard]] const TouchpadReception& handle(Bytes datagram, const Endpoint& from, Instant now,
                                                const TouchpadAnswer& answer) override;
  [[nodiscard]] std::span<const Datagram> advance(Instant now, const TouchpadAnswer& answer) override;
  [[nodiscard]] std::span<const Datagram> farewell(Instant now) override;

  [[nodiscard]] pipeline::LinkPhase phase() const override { return phase_; }
  [[nodiscard]] const std::optional<Endpoint>& peer() const override { return peer_; }
  [[nodiscard]] std::string_view peerText() const override { return robot_text_.view(); }
  [[nodiscard]] bool imagesOn() const override { return images_on_; }
  [[nodiscard]] LinkFigures figures(Instant now) const override;

  [[nodiscard]] const LinkTouchpadCounters& counters() const { return counters_; }
  [[nodiscard]] const LinkRefusalCounters& refusals() const { return refusals_; }
  [[nodiscard]] const Rates& rates() const { return rates_; }
  [[nodiscard]] double lostLimit_ms() const { return connection_ ? connection_->lostLimit_ms(parameters_) : 0.0; }
  [[nodiscard]] const PeerClock* clock() const { return connection_ ? &connection_->clock() : nullptr; }

 private:
  /// So many state periods must fit into the lost limit's cap; otherwise a slow robot would count as lost between two
  /// states.
  static constexpr double kPeriodsWithinCap = 3.0;

  /// A robot's text, cut to the largest size, without allocating.
  class ShortText {
   public:
    ShortText() = default;
    explicit ShortText(std::string_view text) : size_(std::min(text.size(), kMaximumRobotText)) {
      std::copy_n(text.begin(), size_, text_.begin());
    }
    [[nodiscard]] std::string_view view() const { return {text_.data(), size_}; }

   private:
    std::array<char, kMaximumRobotText> text_{};
    std::size_t size_ = 0;
  };

  struct Pending {
    LinkConnection connection;
    Endpoint from;
    PublicKey caller{};
    Rates rates;
    bool tells_force = false;
    PositionCode robot_code;
    ShortText robot_text;
    LinkTime since_us = 0;
    std::array<std::uint8_t, kMaximumLinkDatagram> answer{};
    std::size_t answer_size = 0;
  };

  void refuse(LinkRefusal refusal) { ++refusals_[static_cast<std::size_t>(refusal)]; }
  void passTime(Instant now);
  void takeHello(Bytes datagram, const Endpoint& from);
  void takeCall(Bytes datagram, const Endpoint& from, const TouchpadAnswer& answer);
  void answerCall(Callee& callee, const RobotHello& hello, const Endpoint& from, const PublicKey& caller,
                  const TouchpadAnswer& answer);
  [[nodiscard]] Rates grant(const Rates& wished) const;
  void takeSealed(Bytes datagram, const Endpoint& from, const TouchpadAnswer& answer);
  void takeConfirmation(Bytes datagram);
  void establish();
  void takeMessage(const LinkReceived& received, const TouchpadAnswer& answer);
  void takeState(const LinkReceived& received);
  void takeCommand(const LinkEnvelope& message, const TouchpadAnswer& answer);
  void obey(pipeline::RobotCommand command);
  void sendInfo(const TouchpadAnswer& answer);
  void sendTouch(const TouchpadAnswer& answer);
  [[nodiscard]] bool seenBefore(const PublicKey& caller) const;
  [[nodiscard]] bool mayTakeOver(const Endpoint& from) const;

  LinkParameters parameters_;
  LinkKey key_;
  RandomSource random_;
  CookieJar cookies_;
  SteadyTime time_;
  Instant now_{};
  LinkTime now_us_ = 0;

  std::optional<Pending> pending_;
  std::array<PublicKey, 64> callers_{};  // of the last good calls
  std::size_t next_caller_ = 0;
  std::optional<LinkConnection> connection_;
  std::optional<Endpoint> peer_;
  pipeline::LinkPhase phase_ = pipeline::LinkPhase::waiting;
  Rates rates_;
  bool robot_tells_force_ = false;
  Workspace touch_workspace_;
  PositionCode touch_code_;
  PositionCode robot_code_;
  ShortText robot_text_;
  TouchFields touch_fields_;
  LinkTime established_us_ = 0;
  LinkTime last_state_us_ = 0;
  LinkTime next_touch_us_ = 0;
  LinkTime next_beat_us_ = 0;
  std::uint16_t touch_sequence_ = 0;
  std::uint16_t state_sequence_ = 0;
  bool any_state_ = false;
  std::uint16_t command_id_ = 0;
  bool images_on_ = false;
  bool motor_references_on_ = false;
  ImageSender images_;

  LinkTouchpadCounters counters_;
  LinkRefusalCounters refusals_{};
  TouchpadReception reception_;
  Outbox outbox_;
};

}  // namespace fyd::protocol
