// The robot's side of a classic session: a state machine without socket or clock.
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
#include "core/protocol/classic_codec.h"
#include "core/protocol/datagram.h"

namespace fyd::protocol {

enum class RobotPhase : std::uint8_t {
  handshake,  ///< the touchpad has not answered yet (or went away)
  running,
  paused,   ///< after command 5, until 6; states and touches go on
  closing,  ///< after command 9: states still go out for a while
  closed,   ///< nothing more is sent
};
inline constexpr std::size_t kRobotPhaseCount = 5;
[[nodiscard]] std::string_view toString(RobotPhase phase);

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

/// What the robot has to say at this moment.
struct RobotReport {
  Vec3 acceleration_g;  ///< rest removed
  pipeline::RobotState robot;
  pipeline::RobotMotorReference motor_reference;  ///< sent after command 10
};

/// What one datagram brought.
struct RobotReception {
  bool connected = false;  ///< the handshake is complete
  std::optional<pipeline::TouchMessage> touch;
  bool info = false;   ///< see ClassicRobotEnd::info, boardText
  bool image = false;  ///< see ClassicRobotEnd::image
};

struct RobotCounters {
  std::uint64_t acks = 0;
  std::uint64_t states = 0;
  std::uint64_t touches = 0;           ///< in turn
  std::uint64_t missed_replies = 0;    ///< states whose touch did not come in time
  std::uint64_t cycles_cut_short = 0;  ///< touch came, info or picture did not in time
  std::uint64_t extra_touches = 0;     ///< when none was due; used all the same, the newest is the best
  std::uint64_t infos = 0;
  std::uint64_t images = 0;
  std::uint64_t motor_references = 0;
  std::uint64_t lost = 0;           ///< times the touchpad was given up
  std::uint64_t wrong_peer = 0;     ///< not from the touchpad
  std::uint64_t refused = 0;        ///< from the touchpad, not what was due or damaged
  std::uint64_t waited_cycles = 0;  ///< ticks without a state because the last one's replies were still due
};

class ClassicRobotEnd {
 public:
  /// @param touchpad where the ACK goes; who answers it completely is the touchpad from then on, as the authors do
  ClassicRobotEnd(const ClassicRobotSettings& settings, const Endpoint& touchpad);

  /// One cycle of the robot's clock. The result points into this object until the next call.
  [[nodiscard]] std::span<const Datagram> tick(Instant now, const RobotReport& report);

  /// Takes one datagram. Does not allocate, whatever arrives.
  [[nodiscard]] RobotReception handle(Bytes datagram, const Endpoint& from);

  /// Puts a command into one of the next states, one each. @return false when sixteen are waiting already
  bool command(pipeline::RobotCommand command);

  [[nodiscard]] RobotPhase phase() const { return phase_; }
  [[nodiscard]] bool replyDue() const { return due_ != Due::nothing; }
  [[nodiscard]] const Endpoint& touchpad() const { return touchpad_; }
  [[nodiscard]] const ClassicInfo& info() const { return info_; }
  [[nodiscard]] std::string_view boardText() const { return {board_text_.data(), board_size_}; }
  /// The last complete picture, encoded.
  [[nodiscard]] Bytes image() const { return Bytes(image_).first(image_size_); }
  [[nodiscard]] const RobotCounters& counters() const { return counters_; }

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

  ClassicInfo info_;
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
