// What FYD Link's messages say, as plain structs with units; core/protocol/link/link_codec.h puts them on the wire.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/batch.h"
#include "core/base/message.h"
#include "core/base/vec3.h"
#include "core/control/motor_types.h"
#include "core/pipeline/messages.h"
#include "core/protocol/datagram.h"
#include "core/protocol/position_code.h"

namespace fyd::protocol {

/// Microseconds of a sender's own clock, which never goes back within a session; 48 bits on the wire (8.9 years).
using LinkTime = std::uint64_t;

enum class LinkMessage : std::uint8_t {
  touch = 1,        ///< touchpad → robot
  state = 2,        ///< robot → touchpad
  command = 3,      ///< robot → touchpad, repeated until acknowledged
  command_ack = 4,  ///< touchpad → robot
  heartbeat = 5,    ///< both ways
  info = 6,         ///< touchpad → robot, after command "send info and pause"
  goodbye = 7,      ///< both ways, not acknowledged, sent three times
  image = 8,        ///< touchpad → robot
};

inline constexpr std::size_t kMaximumBoardText = 1'000;
inline constexpr std::size_t kMaximumRobotText = 200;
inline constexpr std::size_t kMaximumBatch = 32;           ///< accelerations in one state
inline constexpr std::size_t kImageFragment = 1'200;       ///< bytes of every fragment but the last
inline constexpr std::size_t kMaximumLinkImage = 131'072;  ///< bytes of an encoded picture

/// Three angles, rad, of the paper's messages (α, β, γ); any value, meant modulo 2π.
struct Orientation {
  double alpha_rad = 0.0;
  double beta_rad = 0.0;
  double gamma_rad = 0.0;
};

/// Fields of a touch that may be left out to fit a slow line [tele-gesture Eq. 2].
struct TouchFields {
  bool force = true;
  bool indentation = true;
  bool orientation = false;
  friend bool operator==(const TouchFields&, const TouchFields&) = default;
};

struct LinkTouch {
  std::uint16_t sequence = 0;  ///< grows by one with each touch, modulo 2¹⁶
  double age_s = 0.0;          ///< how long before the sending x and y were seen; 0…0.65535, 10 µs steps
  Vec3 position_mm;
  bool in_contact = false;
  std::optional<double> force_N;         ///< 0…13.107, 0.2 mN steps
  std::optional<double> indentation_mm;  ///< 0…65.535, 1 µm steps
  std::optional<Orientation> orientation;
};

struct LinkAcceleration {
  double age_s = 0.0;   ///< how long before the sending it was taken; 0…0.26214, 4 µs steps
  Vec3 acceleration_g;  ///< ±5 g in 1/6553 g
};

struct LinkState {
  std::uint16_t sequence = 0;
  pipeline::RobotState robot;  ///< stiffness 0…10⁶ N/mm; force 0…65.535 N, 1 mN steps
  std::optional<Orientation> orientation;
  std::optional<pipeline::RobotMotorReference> motor_reference;  ///< ±10⁶ ticks
  Batch<LinkAcceleration, kMaximumBatch> accelerations;          ///< oldest first
};

struct LinkCommand {
  std::uint16_t id = 0;  ///< grows by one with each command of the session, from 1
  pipeline::RobotCommand command = pipeline::RobotCommand::none;
};

struct LinkCommandAck {
  std::uint16_t id = 0;
};

/// Round trip at the receiver = its now − echo − held; offset of clocks from the same numbers.
struct LinkHeartbeat {
  LinkTime echo_us = 0;       ///< newest sending time heard from the other end
  std::uint32_t held_us = 0;  ///< how long ago that was heard
};

enum class GoodbyeReason : std::uint8_t { leaving = 0, operator_left = 1 };

struct LinkGoodbye {
  GoodbyeReason reason = GoodbyeReason::leaving;
};

struct LinkImageFragment {
  std::uint16_t picture = 0;
  std::uint32_t size = 0;   ///< of the whole picture
  std::uint16_t index = 0;  ///< of this fragment; its offset is index · kImageFragment
  Bytes bytes;
};

/// What an end is able to do, as bits.
enum class Capability : std::uint32_t { images = 1, motor_reference = 2, orientation = 4, force = 8 };

struct Rates {
  double state_Hz = 100.0;  ///< robot → touchpad; 1…10 000, whole
  double touch_Hz = 100.0;  ///< touchpad → robot; likewise
};

/// The robot's self-description, in its call.
struct RobotHello {
  LinkTime sent_us = 0;
  Rates rates;  ///< wished
  Workspace workspace{.minimum_mm = {-200, -200, -200}, .maximum_mm = {200, 200, 200}, .precision_mm = 0.02};
  std::uint32_t capabilities = 0;
  std::string_view text;  ///< printable ASCII, at most kMaximumRobotText
};

enum class CallStatus : std::uint8_t {
  accepted = 0,
  second_robot = 1,  ///< another robot is served
};
[[nodiscard]] constexpr std::string_view toString(CallStatus status) {
  return status == CallStatus::accepted ? sentence("accepted") : sentence("another robot is served");
}

/// The touchpad's self-description, in its answer (thesis: board text, k_vib and both motor references).
struct TouchpadHello {
  CallStatus status = CallStatus::accepted;
  LinkTime sent_us = 0;
  LinkTime echo_us = 0;
  std::uint32_t held_us = 0;
  Rates rates;  ///< granted: what both keep to
  Workspace workspace{.minimum_mm = {-35, -25, -70}, .maximum_mm = {35, 25, 70}, .precision_mm = 0.02};
  std::uint32_t capabilities = 0;
  double k_vib = 1.0;                                          ///< 0…100
  std::array<double, control::kMotorCount> reference_ticks{};  ///< ±10⁶
  std::string_view board_text;                                 ///< printable ASCII, at most kMaximumBoardText
};

/// As in TouchpadHello, again during the session.
struct LinkInfo {
  double k_vib = 1.0;
  std::array<double, control::kMotorCount> reference_ticks{};
  std::string_view board_text;
};

}  // namespace fyd::protocol
