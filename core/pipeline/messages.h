// Messages between touchpad and robot as plain structs with units; the codecs in core/protocol translate them.
// Stability: stable since 0.1
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "core/base/time.h"
#include "core/base/vec3.h"
#include "core/texture/acceleration_sample.h"

namespace fyd::pipeline {

/// Finger position in one picture, converted to a position of the robot, and the picture's capture time.
struct SeenFinger {
  double x_mm = 0.0;
  double y_mm = 0.0;
  Instant taken{};
};

/// Touchpad → robot. Frame: x right, y back, z up, origin at the camera axis on the untouched cloth;
/// pressing is negative z [thesis §4.1.1] [authors' program].
struct TouchMessage {
  Vec3 position_mm;
  bool in_contact = false;  ///< false: the robot holds its x and y
  double force_N = 0.0;     ///< normal force at the finger, ≥ 0
  /// While a finger touches: the position that x and y are moving to. FYD Link, whose messages carry their time, sends
  /// this in place of x and y, so that the robot can extrapolate to the present.
  std::optional<SeenFinger> seen = std::nullopt;
};

/// Robot → touchpad: state-like part.
struct RobotState {
  double stiffness_N_per_mm = 0.0;
  Vec3 position_mm;
  bool button = false;
  /// Force of its tool on what it touches, ≥ 0. NaN: not sent (the classic protocol has no field for it).
  double force_N = std::numeric_limits<double>::quiet_NaN();

  static constexpr auto fields() {
    using R = RobotState;
    return std::tuple(
        Field("stiffness_N_per_mm", "N/mm", "what the robot feels; 0: it touches nothing", &R::stiffness_N_per_mm),
        Field("x_mm", "mm", "of the end effector in the touchpad's frame, x right", inside(&R::position_mm, &Vec3::x)),
        Field("y_mm", "mm", "of the end effector in the touchpad's frame, y back", inside(&R::position_mm, &Vec3::y)),
        Field("z_mm", "mm", "of the end effector in the touchpad's frame, z up", inside(&R::position_mm, &Vec3::z)),
        Field("button", "1", "1: pressed", &R::button),
        Field("force_N", "N", "of its tool on what it touches; none where the protocol does not tell it", &R::force_N));
  }
};

/// Commands the robot's operator sends (the twelve of the classic protocol; value of the classic character − 48).
enum class RobotCommand : std::uint8_t {
  none = 0,
  vibration_down = 1,  ///< k_vib − 0.1
  vibration_up = 2,    ///< k_vib + 0.1
  use_dft321 = 3,
  use_soc = 4,
  send_info_and_pause = 5,
  resume = 6,
  images_on = 7,
  images_off = 8,
  disconnect = 9,
  motor_reference_on = 10,
  motor_reference_off = 11,
};

/// Motor references set by the robot, after motor_reference_on.
struct RobotMotorReference {
  double first_ticks = 0.0;
  double second_ticks = 0.0;

  static constexpr auto fields() {
    using R = RobotMotorReference;
    return std::tuple(Field("first_ticks", "tick", "of the first motor", &R::first_ticks),
                      Field("second_ticks", "tick", "of the second motor", &R::second_ticks));
  }
};

/// Stored in files by number: numbers never change, and a new one takes the next.
enum class LinkPhase : std::uint8_t {
  none = 0,     ///< no robot is wanted
  waiting = 1,  ///< listening for a robot
  running = 2,
  paused = 3,  ///< by agreement of both ends: not a lost link
  closed = 4,  ///< the robot ended the connection
  lost = 5,    ///< silence longer than allowed
};

}  // namespace fyd::pipeline

template <>
inline constexpr auto fyd::kFieldsOf<fyd::pipeline::RobotCommand> =
    std::tuple(fyd::Field("command", "1", "RobotCommand: its number", std::identity()));
