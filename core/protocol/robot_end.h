// The robot's side of the link, whatever the protocol: a state machine without socket or clock.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/base/time.h"
#include "core/pipeline/messages.h"
#include "core/protocol/datagram.h"
#include "core/protocol/link_phase.h"

namespace fyd::protocol {

/// What the robot reports at this moment.
struct RobotReport {
  Vec3 acceleration_g;                            ///< rest removed
  pipeline::RobotState robot;                     ///< its force: FYD Link only
  pipeline::RobotMotorReference motor_reference;  ///< sent after command 10
  std::optional<Instant> acceleration_taken;      ///< FYD Link only; nothing: at the tick
};

/// What one datagram brought.
struct RobotReception {
  bool connected = false;  ///< the handshake is complete
  std::optional<pipeline::TouchMessage> touch;
  /// When the touch was sent and when the finger was seen at its x and y, on the robot's clock. The classic protocol
  /// sends neither: both are then taken as half the cycle before the arrival.
  Instant touch_sent{};
  Instant touch_seen{};
  bool info = false;   ///< the touchpad described itself
  bool image = false;  ///< a picture is complete
};

struct RobotCounters {
  std::uint64_t acks = 0;  ///< handshakes begun: ACKs, hellos
  std::uint64_t states = 0;
  std::uint64_t touches = 0;           ///< received when due
  std::uint64_t missed_replies = 0;    ///< states whose touch did not come in time
  std::uint64_t cycles_cut_short = 0;  ///< touch came, info or picture did not in time
  std::uint64_t extra_touches = 0;     ///< received when none was due; used, because the newest is the best
  std::uint64_t infos = 0;
  std::uint64_t images = 0;
  std::uint64_t motor_references = 0;
  std::uint64_t lost = 0;           ///< times the touchpad fell silent, or sent no touch, for too long
  std::uint64_t wrong_peer = 0;     ///< not from the touchpad
  std::uint64_t refused = 0;        ///< from the touchpad, not what was due or damaged
  std::uint64_t waited_cycles = 0;  ///< ticks without a state because the last one's replies were still due
};

class RobotEnd {
 public:
  virtual ~RobotEnd() = default;

  /// One cycle of the robot's clock. The result points into this object until the next call.
  [[nodiscard]] virtual std::span<const Datagram> tick(Instant now, const RobotReport& report) = 0;
  /// Takes one datagram. Does not allocate, whatever arrives.
  [[nodiscard]] virtual RobotReception handle(Bytes datagram, const Endpoint& from, Instant now) = 0;
  /// Queues a command for sending. @return false when sixteen are waiting already
  virtual bool command(pipeline::RobotCommand command) = 0;

  [[nodiscard]] virtual RobotPhase phase() const = 0;
  /// A reply of this cycle is still due; while closing: the goodbye is not yet sent.
  [[nodiscard]] virtual bool replyDue() const = 0;
  [[nodiscard]] virtual const RobotCounters& counters() const = 0;
  /// How the touchpad described itself, valid until the next call; empty: it did not.
  [[nodiscard]] virtual std::string_view boardText() const = 0;
  /// Why there is no link yet, for the robot's operator; empty when there is one.
  [[nodiscard]] virtual std::string_view problem() const = 0;
};

}  // namespace fyd::protocol
