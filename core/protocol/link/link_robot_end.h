// The robot's side of FYD Link.
//
//   hello, again every `retry` until challenged → call, again every `retry`, for `call_life` at most → answer
//     accepted: running; the first heartbeat under the new keys makes the session the touchpad's
//     refused:  the reason is kept, and a new hello goes out after `refused_pause`
//
// Running. Each tick's acceleration is collected with its time; a state carries all since the last one, at the
// negotiated rate; heartbeats go half-way between. One command at a time is repeated until acknowledged (after
// max(20 ms, two round trips)), so that each is taken exactly once and in order. Command 5 is acknowledged by the
// info it asks for, command 9 is the goodbye.
//
// Silence of the touchpad: lost after the limit of LinkConnection (not while paused), a new call after `give_up`.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/protocol/link/image_transfer.h"
#include "core/protocol/link/link_connection.h"
#include "core/protocol/link/link_handshake.h"
#include "core/protocol/link/outbox.h"
#include "core/protocol/robot_end.h"
#include "core/protocol/touchpad_end.h"

namespace fyd::protocol {

struct LinkRobotSettings {
  Rates rates;  ///< wished
  Workspace workspace = RobotHello{}.workspace;
  std::string_view text = "robot";  ///< static storage
  LinkParameters limits;            ///< freshness and the lost link's cap
  Duration retry = std::chrono::milliseconds(250);
  Duration call_life = std::chrono::seconds(2);
  Duration refused_pause = std::chrono::seconds(1);
  Duration give_up = std::chrono::seconds(1);
  Duration give_up_paused = std::chrono::seconds(10);
};

struct LinkRobotCounters {
  std::uint64_t calls = 0;
  std::uint64_t sessions = 0;
  std::uint64_t heartbeats = 0;
  std::uint64_t commands = 0;  ///< acknowledged
  std::uint64_t command_repeats = 0;
  std::uint64_t samples_dropped = 0;  ///< accelerations for which the batch had no room
};

class LinkRobotEnd final : public RobotEnd {
 public:
  LinkRobotEnd(const LinkRobotSettings& settings, const LinkKey& key, const Endpoint& touchpad,
               RandomSource random = systemRandom);

  [[nodiscard]] std::span<const Datagram> tick(Instant now, const RobotReport& report) override;
  [[nodiscard]] RobotReception handle(Bytes datagram, const Endpoint& from, Instant now) override;
  bool command(pipeline::RobotCommand command) override;

  [[nodiscard]] RobotPhase phase() const override { return phase_; }
  [[nodiscard]] bool replyDue() const override { return farewells_left_ > 0; }
  [[nodiscard]] const RobotCounters& counters() const override { return counters_; }
  [[nodiscard]] std::string_view problem() const override;

  [[nodiscard]] const LinkRobotCounters& linkCounters() const { return link_counters_; }
  [[nodiscard]] const LinkRefusalCounters& refusals() const { return refusals_; }
  /// Why the last call was not accepted.
  [[nodiscard]] CallStatus lastStatus() const { return status_; }
  [[nodiscard]] const Rates& rates() const { return rates_; }
  [[nodiscard]] const TouchpadInfo& info() const { return info_; }
  [[nodiscard]] std::string_view boardText() const override { return {board_text_.data(), board_size_}; }
  [[nodiscard]] const std::optional<LinkTouch>& touch() const { return touch_; }
  [[nodiscard]] Bytes image() const { return images_.image(); }
  [[nodiscard]] const LinkConnection* connection() const { return connection_ ? &*connection_ : nullptr; }
  [[nodiscard]] double lostLimit_ms() const { return connection_ ? connection_->lostLimit_ms(settings_.limits) : 0.0; }

 private:
  struct Sample {
    LinkTime taken_us = 0;
    Vec3 acceleration_g;
  };

  void refuse(LinkRefusal refusal);
  void passTime(Instant now);
  void startOver();
  void tickHandshake();
  void collect(Instant now, const RobotReport& report);
  void sendState(const RobotReport& report);
  void sendCommand();
  void sendFarewell();
  void takeChallenge(Bytes datagram);
  void takeAnswer(Bytes datagram, RobotReception& out);
  void takeSealed(Bytes datagram, RobotReception& out);
  void takeTouch(const LinkReceived& received, RobotReception& out);
  void acknowledged();
  void nextCommand();
  void takeInfo(double k_vib, const std::array<double, control::kMotorCount>& ticks, std::string_view text);

  LinkRobotSettings settings_;
  LinkKey key_;
  Endpoint touchpad_;
  RandomSource random_;
  SteadyTime time_;
  LinkTime now_us_ = 0;
  Instant now_{};  // of the datagram
  RobotPhase phase_ = RobotPhase::handshake;

  HelloNonce nonce_{};
  bool greeted_ = false;  // nonce_ is this handshake's
  LinkTime next_try_us_ = 0;
  std::optional<Caller> caller_;
  LinkTime called_us_ = 0;
  std::array<std::uint8_t, kMaximumLinkDatagram> call_{};
  std::size_t call_size_ = 0;
  CallStatus status_ = CallStatus::accepted;

  std::optional<LinkConnection> connection_;
  Rates rates_;
  PositionCode own_code_;
  PositionCode touch_code_;
  LinkTime next_state_us_ = 0;
  LinkTime next_beat_us_ = 0;
  std::uint16_t state_sequence_ = 0;
  std::uint16_t touch_sequence_ = 0;
  std::optional<LinkTouch> touch_;
  LinkTime last_touch_us_ = 0;
  std::uint64_t lost_at_touch_ = 0;
  Batch<Sample, kMaximumBatch> samples_;
  std::optional<LinkTime> last_sample_us_;
  bool motor_references_on_ = false;

  Batch<pipeline::RobotCommand, 16> commands_;
  std::uint16_t command_id_ = 0;
  pipeline::RobotCommand outstanding_ = pipeline::RobotCommand::none;
  LinkTime next_command_us_ = 0;
  int farewells_left_ = 0;
  LinkTime next_farewell_us_ = 0;

  TouchpadInfo info_;
  std::array<char, kMaximumBoardText> board_text_{};
  std::size_t board_size_ = 0;
  ImageReceiver images_;

  RobotCounters counters_;
  LinkRobotCounters link_counters_;
  LinkRefusalCounters refusals_{};
  Outbox outbox_;
};

}  // namespace fyd::protocol
