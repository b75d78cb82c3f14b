// FRI 1.0, the wire between a KUKA LWR's controller (KRC) and a remote computer: UDP, little-endian, 4-byte packing.
// The KRC sends a measurement every 1…100 ms; the remote answers each with a command that reflects its sequence number.
//
// Byte offsets [KUKA FRI], f: 32-bit float, both messages:
//   0 u16 sequence · 2 u16 reflected sequence · 4 u16 size · 6 u16 id · 8 f×16 KRL reals · 72 i32×16 KRL integers ·
//   136 u16 KRL booleans · 138 padding
// Measurement, 916 bytes, id 0x2006:
//   140 f time · 144 u16 state · 146 u16 quality · 148 f, 152 f wished sample times · 156 f safety limits ·
//   160 f answer rate · 164 f latency · 168 f jitter · 172 f miss rate · 176 u32 misses ·
//   180 u16 power · 182 u16 control · 184 u16 error · 186 u16 warning · 188 f×7 temperatures ·
//   216 f×7 joints · 244 f×12 frame · 292 f×7 commanded joints · 320 f×7 joint offsets · 348 f×12 commanded frame ·
//   396 f×12 frame offset · 444 f×7 torques · 472 f×7 external torques ·
//   500 f×6 tool force-torque (Fx Fy Fz Tz Ty Tx) · 524 f×42 Jacobian (6 × 7) · 692 f×49 mass matrix (7 × 7) ·
//   888 f×7 gravity
// Command, 376 bytes, id 0x1005:
//   140 u32 flags · 144 f×7 joints · 172 f×12 frame · 220 f×7 torques · 248 f×6 force-torque ·
//   272 f×7 joint stiffness · 300 f×7 joint damping · 328 f×6 Cartesian stiffness · 352 f×6 Cartesian damping
//
// Reading is strict: exact size, size field and id, a known state, quality and strategy, and finite numbers throughout.
// Units: m, rad, N, Nm, s. Nothing allocates.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/protocol/datagram.h"

namespace fyd::protocol {

inline constexpr std::size_t kFriMeasurementSize = 916;
inline constexpr std::size_t kFriCommandSize = 376;
inline constexpr std::uint16_t kFriMeasurementId = 0x2006;
inline constexpr std::uint16_t kFriCommandId = 0x1005;
inline constexpr std::uint16_t kFriPort = 49938;  ///< of the remote, where the KRC sends to

enum class FriState : std::uint16_t { off = 0, monitor = 1, command = 2 };
enum class FriQuality : std::uint16_t { unacceptable = 0, bad = 1, good = 2, perfect = 3 };
enum class FriControl : std::uint16_t { other = 0, position = 1, cartesian_impedance = 2, joint_impedance = 3 };
[[nodiscard]] std::string_view toString(FriState state);
[[nodiscard]] std::string_view toString(FriQuality quality);
[[nodiscard]] std::string_view toString(FriControl control);

namespace fri_flag {
inline constexpr std::uint32_t kJoints = 0x1;
inline constexpr std::uint32_t kTorques = 0x4;
inline constexpr std::uint32_t kJointStiffness = 0x10;
inline constexpr std::uint32_t kJointDamping = 0x20;
inline constexpr std::uint32_t kFrame = 0x100;
inline constexpr std::uint32_t kForceTorque = 0x400;
inline constexpr std::uint32_t kCartesianStiffness = 0x1000;
inline constexpr std::uint32_t kCartesianDamping = 0x2000;
}  // namespace fri_flag

using FriJoints = std::array<float, 7>;
/// Rows of a 3 × 4 matrix: rotation in columns 0…2, translation (m) in column 3.
using FriFrame = std::array<float, 12>;
using FriVector6 = std::array<float, 6>;

struct FriHeader {
  std::uint16_t sequence = 0;
  std::uint16_t reflected = 0;  ///< the newest sequence number heard from the other end
};

/// Shared with the robot program that runs on the KRC; its meaning is that program's.
struct FriKrl {
  std::array<float, 16> reals{};
  std::array<std::int32_t, 16> integers{};
  std::uint16_t booleans = 0;
};

struct FriMeasurement {
  FriHeader header;
  FriKrl krl;
  float time_s = 0;
  FriState state = FriState::off;
  FriQuality quality = FriQuality::unacceptable;
  float measurement_period_s = 0;  ///< wished
  float command_period_s = 0;      ///< wished
  float safety_limits = 0;
  float answer_rate = 0;  ///< share of answers, 0…1
  float latency_s = 0;
  float jitter_s = 0;
  float miss_rate = 0;
  std::uint32_t misses = 0;
  std::uint16_t power = 0;  ///< one bit for each drive
  FriControl control = FriControl::other;
  std::uint16_t error = 0;    ///< one bit for each drive
  std::uint16_t warning = 0;  ///< likewise
  FriJoints temperatures_C{};
  FriJoints joints{};
  FriFrame frame{};
  FriJoints commanded_joints{};
  FriJoints joint_offsets{};
  FriFrame commanded_frame{};
  FriFrame frame_offset{};
  FriJoints torques{};
  FriJoints external_torques{};
  FriVector6 force_torque{};  ///< Fx Fy Fz Tz Ty Tx
  std::array<float, 42> jacobian{};
  std::array<float, 49> mass{};
  FriJoints gravity{};
};

struct FriCommand {
  FriHeader header;
  FriKrl krl;
  std::uint32_t flags = 0;  ///< fri_flag; what is not flagged is ignored by the KRC
  FriJoints joints{};
  FriFrame frame{};
  FriJoints torques{};
  FriVector6 force_torque{};
  FriJoints joint_stiffness{};
  FriJoints joint_damping{};
  FriVector6 cartesian_stiffness{};  ///< N/m ×3, Nm/rad ×3
  FriVector6 cartesian_damping{};    ///< 1
};

enum class FriRefusal : std::uint8_t {
  none,
  wrong_size,  ///< the datagram's
  wrong_size_field,
  wrong_id,
  unknown_value,  ///< of state, quality or control strategy
  not_finite,
};
inline constexpr std::size_t kFriRefusalCount = 6;
[[nodiscard]] std::string_view toString(FriRefusal refusal);

[[nodiscard]] std::array<std::uint8_t, kFriMeasurementSize> encodeFriMeasurement(const FriMeasurement& measurement);
[[nodiscard]] std::array<std::uint8_t, kFriCommandSize> encodeFriCommand(const FriCommand& command);
/// @param out undefined contents unless the result is `none`
[[nodiscard]] FriRefusal decodeFriMeasurement(Bytes datagram, FriMeasurement& out);
[[nodiscard]] FriRefusal decodeFriCommand(Bytes datagram, FriCommand& out);

}  // namespace fyd::protocol
