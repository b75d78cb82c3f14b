// The robot's side of a classic link: a state machine without socket or clock.
//
//   handshake (ACK, again every `ack_retry` until answered) → running ⇄ paused → closing → closed
//                         ▲────────────────────────── lost ◀──┘ (`misses_until_lost` replies missing in a row)
//
// A cycle: `tick` gives the state to send; then the touch must come back, the info triple after command 5, and a
// picture while images are on; only then does the next tick send again. When the cycle is not complete within
// `reply_timeout` it is given up, counted, and the next state goes out. The authors' program waits for ever when
// wired, and 1 s, twice, when wireless: `wired()` and `wireless()` behave so.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/batch.h"
#include "core/base/time.h"
#include "core/pipeline/messages.h"
#include "core/protocol/classic/classic_codec.h"
#include "core/protocol/datagram.h"
#include "core/protocol/robot_end.h"

namespace fyd::protocol {

struct ClassicRobotSettings {
  Duration reply_timeout = std::chrono::milliseconds(100);
  int misses_until_lost = 10;
  Duration ack_retry = std::chrono::milliseconds(500);  ///< zero: the ACK is sent once, as the authors do
  Duration closing = std::chrono::seconds(3);

  [[nodiscard]] static ClassicRobotSettings wired() {
    return {.reply_timeout = Duration::max(), .ack_retry = Duration::zero()};
  }
  [[nodiscard]] static ClassicRobotSettings wireless() {
    return {.reply_timeout = std::chrono::seconds(1), .misses_until_lost = 2, .ack_retry = Duration::zero()};
  }
};

class ClassicRobotEnd final : public RobotEnd {
 public:
  /// @param touchpad where the ACK goes; who answers it completely is the touchpad from then on, as the authors do
  ClassicRobotEnd(const ClassicRobotSettings& settings, const Endpoint& touchpad);

  [[nodiscard]] std::span<const Datagram> tick(Instant now, const RobotReport& report) override;

  [[nodiscard]] RobotReception handle(Bytes datagram, const Endpoint& from);
  [[nodiscard]] RobotReception handle(Bytes datagram, const Endpoint& from, Instant now) override;

  /// Puts a command into one of the next states, one each.
  bool command(pipeline::RobotCommand command) override;

  [[nodiscard]] RobotPhase phase() const override { return phase_; }
  [[nodiscard]] bool replyDue() const override { return due_ != Due::nothing; }
  [[nodiscard]] const Endpoint& touchpad() const { return touchpad_; }
  [[nodiscard]] const TouchpadInfo& info() const { return info_; }
  [[nodiscard]] std::string_view boardText() const override { return {board_text_.data(), board_size_}; }
  /// The last complete picture, encoded.
  [[nodiscard]] Bytes image() const { return Bytes(image_).first(image_size_); }
  [[nodiscard]] const RobotCounters& counters() const override { return counters_; }
  [[nodiscard]] std::string_view problem() const override {
    return phase_ == RobotPhase::handshake ? sentence("no touchpad answered") : "";
  }

 private:
  enum class Due : std::uint8_t { nothing, touch, info_length, info_text, info_values, image_length, image_bytes };

  void send(Bytes bytes);
  void sendAck(Instant now);
  void sendState(Instant now, const RobotReport& report);
  void act(pipeline::RobotCommand command, Instant now);
  void giveUpCycle();
  void nextDue();
  void takeTouch(const pipeline::TouchMessage& touch, RobotReception& out);
  void takeInfo(Bytes datagram, const Endpoint& from, RobotReception& out);
  void takeImage(Bytes datagram, RobotReception& out);

  ClassicRobotSettings settings_;
  Endpoint configured_touchpad_;
  Endpoint touchpad_;
  RobotPhase phase_ = RobotPhase::handshake;
  Due due_ = Due::nothing;
  bool info_wanted_ = false;             // in this cycle, still to come
  bool image_wanted_ = false;            // likewise
  bool motor_reference_wanted_ = false;  // goes out before the next state
  bool images_on_ = false;
  int misses_ = 0;           // touches, in a row
  int pictures_missed_ = 0;  // likewise
  std::optional<Instant> ack_sent_;
  Instant state_sent_{};
  std::optional<Instant> closing_since_;
  Batch<pipeline::RobotCommand, 16> commands_;

  TouchpadInfo info_;
  std::array<char, kClassicMaximumBoardText> board_text_{};
  std::size_t board_size_ = 0;
  std::size_t board_expected_ = 0;
  std::vector<std::uint8_t> incoming_image_;
  std::size_t incoming_size_ = 0;
  std::size_t image_expected_ = 0;
  std::vector<std::uint8_t> image_;
  std::size_t image_size_ = 0;
  RobotCounters counters_;

  Batch<Datagram, 2> outgoing_;
  std::array<std::uint8_t, kClassicAckSize> ack_bytes_{};
  std::array<std::uint8_t, kClassicStateSize> state_bytes_{};
  std::array<std::uint8_t, kClassicMotorReferenceSize> motor_bytes_{};
};

}  // namespace fyd::protocol
