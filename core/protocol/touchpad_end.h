// The touchpad's side of the link, whatever the protocol: a state machine without socket or clock. The caller hands
// in each datagram with its sender and arrival time, sends the replies in their order from the one port, calls
// `advance` at least every few milliseconds and sends what that gives. Nothing of it allocates.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "core/base/batch.h"
#include "core/base/time.h"
#include "core/control/motor_types.h"
#include "core/pipeline/messages.h"
#include "core/protocol/datagram.h"

namespace fyd::protocol {

/// Part of the touchpad's self-description.
struct TouchpadInfo {
  double k_vib = 1.0;                                          ///< classic: 0…99.9 in tenths
  std::array<double, control::kMotorCount> reference_ticks{};  ///< both motors
};

/// What the touchpad replies at this moment. Text and image must outlive the sending of the replies.
struct TouchpadAnswer {
  pipeline::TouchMessage touch;
  Instant taken{};  ///< time of the touch; the classic protocol has no field for it
  TouchpadInfo info;
  std::string_view board_text;  ///< cut at the protocol's limit
  Bytes image;                  ///< an encoded picture
};

/// What one datagram brought.
struct TouchpadReception {
  static constexpr std::size_t kMaximumReplies = 64;
  static constexpr std::size_t kMaximumSamples = 32;

  bool session_started = false;  ///< a robot completed the handshake
  bool was_lost = false;         ///< the silence before this datagram was a loss, though the phase may be running again
  std::optional<pipeline::RobotState> state;  ///< what a truncated packet misses keeps its last value
  /// Oldest first. Classic: taken at the datagram's arrival. FYD Link: time as stated by the robot,
  /// converted to the touchpad's clock.
  Batch<texture::AccelerationSample, kMaximumSamples> accelerations;
  pipeline::RobotCommand command = pipeline::RobotCommand::none;  ///< for the pipeline to act upon
  std::optional<pipeline::RobotMotorReference> motor_reference;
  Batch<Datagram, kMaximumReplies> replies;  ///< send all, in this order
  bool image_used = false;                   ///< the answer's picture is in the replies, or too large for them

  void clear() {
    session_started = false;
    was_lost = false;
    state.reset();
    accelerations.clear();
    command = pipeline::RobotCommand::none;
    motor_reference.reset();
    replies.clear();
    image_used = false;
  }
};

/// Why datagrams were refused: name and count, of those that occurred.
struct RefusalCount {
  std::string_view reason;
  std::uint64_t count = 0;
};

/// How the link is doing, in figures that mean the same in every protocol.
struct LinkFigures {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::uint64_t states = 0;      ///< of the robot
  std::uint64_t touches = 0;     ///< to the robot
  std::uint64_t refused = 0;     ///< datagrams counted and not used
  std::uint64_t lost = 0;        ///< times the link was declared lost
  std::uint64_t heartbeats = 0;  ///< the robot's that measured the round trip anew (FYD Link only)
  double silence_ms = kUnknown;
  double period_ms = kUnknown;  ///< between states
  double jitter_ms = kUnknown;
  double lost_limit_ms = kUnknown;
  double round_trip_ms = kUnknown;    ///< FYD Link only, as the following
  double clock_offset_ms = kUnknown;  ///< the robot's clock less the touchpad's
  double loss_percent = kUnknown;
  /// How old an acceleration may be when it arrives: transmission, wait for its batch, jitter.
  double sample_delay_ms = kUnknown;
  Batch<RefusalCount, 24> refusals;
};

class TouchpadEnd {
 public:
  virtual ~TouchpadEnd() = default;
  /// "classic, not secured" or "FYD Link, sealed".
  [[nodiscard]] virtual std::string_view name() const = 0;

  /// Takes one datagram. The result, and the bytes its replies point to, are valid until the next call.
  [[nodiscard]] virtual const TouchpadReception& handle(Bytes datagram, const Endpoint& from, Instant now,
                                                        const TouchpadAnswer& answer) = 0;
  /// Advances the time: declares a silent peer lost. @return what is to be sent now without a request, valid until the
  /// next call
  [[nodiscard]] virtual std::span<const Datagram> advance(Instant now, const TouchpadAnswer& answer) = 0;
  /// Ends the link from this side. @return the datagrams that tell the robot so
  [[nodiscard]] virtual std::span<const Datagram> farewell(Instant now) = 0;

  [[nodiscard]] virtual pipeline::LinkPhase phase() const = 0;
  [[nodiscard]] virtual const std::optional<Endpoint>& peer() const = 0;
  /// How the peer described itself, valid until the next call; empty: it did not.
  [[nodiscard]] virtual std::string_view peerText() const { return {}; }
  [[nodiscard]] virtual bool imagesOn() const = 0;
  [[nodiscard]] virtual LinkFigures figures(Instant now) const = 0;
};

}  // namespace fyd::protocol
