// Every packet of the classic FYD protocol, byte for byte (resources/manual/protocol-classic.md has the layouts):
// ASCII over UDP, numbers as a sign character ('0' for ≥ 0, '1' for < 0), an apostrophe and five digits.
//
// Writing is exact and saturating: positions in whole mm truncated toward zero (as the authors do), everything else
// rounded to the nearest count, magnitudes held at 32767, what is not a number written as zero (a position of which
// any component is not finite is written 0 0 0: hold x and y, lift). Nothing ever wraps.
// Reading is tolerant where the authors' robot program deviates: NUL padding behind the packet, magnitudes printed
// with six characters ("-25536", a 16-bit overflow, is 40000) and the end of the packet that is then cut off at its
// size. Anything else that is out of shape is refused with a reason, and nothing of it is used.
// Pure functions; none allocates or throws.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/base/vec3.h"
#include "core/control/motor_types.h"
#include "core/pipeline/messages.h"
#include "core/protocol/datagram.h"
#include "core/protocol/touchpad_end.h"

namespace fyd::protocol {

inline constexpr std::uint16_t kClassicPort = 3490;
inline constexpr std::size_t kClassicStateSize = 62;
inline constexpr std::size_t kClassicTouchSize = 34;
inline constexpr std::size_t kClassicAckSize = 62;
inline constexpr std::size_t kClassicInfoLengthSize = 5;
inline constexpr std::size_t kClassicInfoValuesSize = 20;
inline constexpr std::size_t kClassicMotorReferenceSize = 17;
inline constexpr std::size_t kClassicImageLengthSize = 6;

inline constexpr std::size_t kClassicMaximumBoardText = 1'209;  ///< bytes, inclusive
inline constexpr std::size_t kClassicMaximumImage = 57'599;     ///< bytes, inclusive

inline constexpr double kClassicCountsPerG = 6553.0;
inline constexpr double kClassicCountsPerNewton = 1e4;
inline constexpr double kClassicCountsPerStiffness = 1e4;  ///< per N/mm
inline constexpr int kClassicMaximumCount = 32'767;        ///< largest magnitude ever written

/// Why a packet was not taken.
enum class ClassicRefusal : std::uint8_t {
  none,       ///< it was taken
  size,       ///< shorter or longer than the packet
  mark,       ///< does not start or end with its marks
  sign,       ///< neither '0' nor '1' where a sign belongs
  digit,      ///< not a digit where one belongs
  separator,  ///< wrong character between two fields
  command,    ///< command character outside '0'…';'
  button,     ///< neither '0' nor '1'
  range,      ///< a number no sender of this protocol can mean
};
inline constexpr std::size_t kClassicRefusalCount = 9;
[[nodiscard]] std::string_view toString(ClassicRefusal refusal);

template <class T>
struct Decoded {
  T value{};
  ClassicRefusal refusal = ClassicRefusal::none;
  [[nodiscard]] bool ok() const { return refusal == ClassicRefusal::none; }
};

/// Robot → touchpad, once a cycle.
struct ClassicState {
  pipeline::RobotCommand command = pipeline::RobotCommand::none;
  Vec3 acceleration_g;  ///< rest removed
  pipeline::RobotState robot;
  bool stiffness_known = true;  ///< false: a six-character number before it pushed it out of the packet; it is then 0
};
[[nodiscard]] std::array<std::uint8_t, kClassicStateSize> encodeState(const ClassicState& state);
/// A negative stiffness is read as 0: the robot touches nothing.
[[nodiscard]] Decoded<ClassicState> decodeState(Bytes packet);
/// A state by its size and one of its marks, whatever stands between: its sender waits for a touch.
[[nodiscard]] bool looksLikeState(Bytes packet);

/// Touchpad → robot, once for each state. Not in contact is written x = y = 0, which means "hold the last".
[[nodiscard]] std::array<std::uint8_t, kClassicTouchSize> encodeTouch(const pipeline::TouchMessage& touch);
/// `in_contact` is false when x and y are both 0. A negative force is read as 0.
[[nodiscard]] Decoded<pipeline::TouchMessage> decodeTouch(Bytes packet);

/// Robot → touchpad, the handshake: "ACK" and NULs.
[[nodiscard]] std::array<std::uint8_t, kClassicAckSize> encodeAck();
/// "ACK" followed by nothing but NULs, at most 62 bytes in all.
[[nodiscard]] bool isAck(Bytes packet);

// Touchpad → robot, after the handshake and after command 5: length, board text, and the values of a TouchpadInfo,
// whose k_vib is written as three digits of 10·k_vib.
/// @param length at most kClassicMaximumBoardText; longer is written as that
[[nodiscard]] std::array<std::uint8_t, kClassicInfoLengthSize> encodeInfoLength(std::size_t length);
[[nodiscard]] Decoded<std::size_t> decodeInfoLength(Bytes packet);
[[nodiscard]] std::array<std::uint8_t, kClassicInfoValuesSize> encodeInfoValues(const TouchpadInfo& info);
[[nodiscard]] Decoded<TouchpadInfo> decodeInfoValues(Bytes packet);

/// Robot → touchpad, unanswered, after command 10.
[[nodiscard]] std::array<std::uint8_t, kClassicMotorReferenceSize> encodeMotorReference(
    const pipeline::RobotMotorReference& reference);
[[nodiscard]] Decoded<pipeline::RobotMotorReference> decodeMotorReference(Bytes packet);

/// Touchpad → robot, while images are on: length, then that many bytes.
[[nodiscard]] std::array<std::uint8_t, kClassicImageLengthSize> encodeImageLength(std::size_t length);
[[nodiscard]] Decoded<std::size_t> decodeImageLength(Bytes packet);

}  // namespace fyd::protocol
