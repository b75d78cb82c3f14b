// The touchpad's side of a classic link: a state machine without socket or clock. The caller hands in each
// datagram with its sender and arrival time, sends the replies in their order from the one port, and calls
// `advance` when nothing came.
//
// In step. The robot sends a state and waits for its touch; there is no sequence number, so a missing or an extra
// reply puts it out of step for good. Therefore every datagram of the session's peer that is a state, or is a state
// by its size (62 bytes) and one of its marks (leading "?" or closing ".\n") but damaged within, gets exactly one
// touch: whatever the phase, whatever the safety state. What is damaged is not used. Nothing else is answered,
// except a valid ACK (by the info triple). Order in a cycle: touch, info (after command 5), image (while on).
//
// Peer. The first valid ACK names the peer; datagrams of others are counted and ignored. A new ACK starts a new
// session: from the same address at any time; from another one when the peer said goodbye or was silent for
// `takeover_silence_s` (a link lost for an instant cannot be taken over). While the old peer's farewell lasts
// (`closing_s`), its states are still answered.
//
// Lost: running, and without a sound state for longer than max(20 ms, 3 · period + jitter), at most `lost_cap_ms`:
// damaged ones are answered, and are no sign of life. Period is the smoothed time between states, jitter four times its smoothed mean deviation. A negotiated pause is no loss.
// When a lost peer's states come back they are answered and the phase is running again; whether anything moves
// then is not decided here (the safety states latch).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/base/batch.h"
#include "core/base/time.h"
#include "core/pipeline/messages.h"
#include "core/protocol/classic/classic_codec.h"
#include "core/protocol/datagram.h"
#include "core/protocol/link_parameters.h"
#include "core/protocol/link_phase.h"
#include "core/protocol/touchpad_end.h"

namespace fyd::protocol {

/// Everything that ever arrived is in exactly one of these, except that `states` counts damaged and cut ones as well.
struct TouchpadCounters {
  std::uint64_t acks = 0;              ///< handshakes taken
  std::uint64_t states = 0;            ///< states answered, damaged and cut ones included
  std::uint64_t states_damaged = 0;    ///< recognised and answered, not used
  std::uint64_t states_cut = 0;        ///< used as far as they went
  std::uint64_t farewell_states = 0;   ///< of a former peer, answered, not used
  std::uint64_t motor_references = 0;  ///< taken
  std::uint64_t wrong_peer = 0;        ///< from an address that is not the session's
  std::uint64_t second_robot = 0;      ///< valid ACK of another robot while one is served
  std::uint64_t before_handshake = 0;  ///< no peer yet
  std::uint64_t out_of_turn = 0;       ///< motor references without command 10
  std::uint64_t unrecognised = 0;      ///< from the peer, neither ACK, state nor motor references
  std::uint64_t touches = 0;           ///< replies written
  std::uint64_t images = 0;            ///< pictures written
  std::uint64_t lost = 0;              ///< times the link was declared lost
  std::array<std::uint64_t, kClassicRefusalCount> refusals{};  ///< why, of states_damaged and unrecognised

  /// Datagrams that were counted and not used.
  [[nodiscard]] std::uint64_t refused() const {
    return states_damaged + wrong_peer + second_robot + before_handshake + out_of_turn + unrecognised;
  }
};

class ClassicTouchpadEnd final : public TouchpadEnd {
 public:
  explicit ClassicTouchpadEnd(const LinkParameters& parameters);
  void configure(const LinkParameters& parameters) { parameters_ = parameters; }

  [[nodiscard]] std::string_view name() const override { return sentence("classic, not secured"); }
  [[nodiscard]] const TouchpadReception& handle(Bytes datagram, const Endpoint& from, Instant now,
                                                const TouchpadAnswer& answer) override;
  /// Advances the time: declares a silent peer lost.
  void advance(Instant now);
  [[nodiscard]] std::span<const Datagram> advance(Instant now, const TouchpadAnswer& /*answer*/) override {
    advance(now);
    return {};
  }
  /// The protocol has no word for it: the robot hears silence.
  [[nodiscard]] std::span<const Datagram> farewell(Instant /*now*/) override { return {}; }

  [[nodiscard]] pipeline::LinkPhase phase() const override { return phase_; }
  [[nodiscard]] const std::optional<Endpoint>& peer() const override { return peer_; }
  [[nodiscard]] bool imagesOn() const override { return images_on_; }
  [[nodiscard]] LinkFigures figures(Instant now) const override;
  [[nodiscard]] const TouchpadCounters& counters() const { return counters_; }

  [[nodiscard]] Duration lostLimit() const;
  [[nodiscard]] double periodMs() const { return period_ms_; }  ///< smoothed; 0 before two states
  [[nodiscard]] double jitterMs() const;                        ///< four mean deviations of the period
  /// Since the last datagram of the peer that was used, damaged states being none; zero before the first.
  [[nodiscard]] Duration silence(Instant now) const;

 private:
  void handleAck(const Endpoint& from, Instant now, const TouchpadAnswer& answer);
  void handlePeer(Bytes datagram, Instant now, const TouchpadAnswer& answer);
  void handleStranger(Bytes datagram, const Endpoint& from, Instant now, const TouchpadAnswer& answer);
  void useState(const ClassicState& state, Instant now);
  void obey(pipeline::RobotCommand command, Instant now);
  [[nodiscard]] bool mayTakeOver(const Endpoint& from, Instant now) const;
  void measure(Instant now);
  void reply(Bytes bytes, const Endpoint& to);
  void replyTouch(const Endpoint& to, const TouchpadAnswer& answer);
  void replyInfo(const TouchpadAnswer& answer);
  void replyImage(const TouchpadAnswer& answer);

  LinkParameters parameters_;
  pipeline::LinkPhase phase_ = pipeline::LinkPhase::waiting;
  std::optional<Endpoint> peer_;
  std::optional<Endpoint> farewell_peer_;
  Instant farewell_until_{};
  Instant closed_at_{};
  Instant last_heard_{};
  std::optional<Instant> last_state_;
  double period_ms_ = 0.0;
  double deviation_ms_ = 0.0;
  bool images_on_ = false;
  bool motor_references_on_ = false;
  pipeline::RobotState robot_;
  TouchpadCounters counters_;

  TouchpadReception reception_;
  std::array<std::uint8_t, kClassicTouchSize> touch_{};
  std::array<std::uint8_t, kClassicInfoLengthSize> info_length_{};
  std::array<std::uint8_t, kClassicInfoValuesSize> info_values_{};
  std::array<std::uint8_t, kClassicImageLengthSize> image_length_{};
};

}  // namespace fyd::protocol
