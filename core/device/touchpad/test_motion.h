// Motions for testing and calibrating the motors, as a pure sequence of commands: small, slow ones by which an operator
// sees that a motor answers, and longer ones for calibrations.
//
//   motor 1, motor 2   0.3 s at rest, 2° out in 2 s, back in 2 s, 0.2 s at rest:  rest + 2°·(1 − cos(2πt/4 s))/2,
//                      1.6°/s at most; inward when 2° outward would pass the motor's limit
//   vibration          0.3 s at rest, 0.5 s of both motors at 150 Hz and 10 % duty, rising and falling over 0.1 s
//
//   stretch            0.3 s at rest, then both motors to a stretch at 16°/s at most, and there for a minute
//   sweep              both motors by steps of 5° from stretch 0 to 30° and back, 1.2 s a step: for the encoders
//   breakaway          at rest, the duty of one motor from 0 up to 40 % at 5 %/s: each motor, both directions
//   chirp              both motors to a stretch, then 8 s of a common duty of 90 % amplitude, swept from 8 to 350 Hz
//
// The rest position is where the motors stand at the start, so that switching them on moves nothing. The sweep begins
// at the motors' own zero instead: it serves to find the encoders' zeros and signs, so their readings are not used. The
// cloth is slack there, and motors that are off stand there anyway.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/error.h"
#include "core/base/message.h"
#include "core/base/time.h"
#include "core/control/motor_types.h"

namespace fyd::device {

enum class DeviceTest : std::uint8_t { motor_1, motor_2, vibration, stretch, sweep, breakaway, chirp };
inline constexpr std::array<std::string_view, 7> kDeviceTestNames = {
    sentence("motor 1"), sentence("motor 2"),   sentence("vibration"), sentence("stretch"),
    sentence("sweep"),   sentence("breakaway"), sentence("chirp")};
/// The first three test one part each; the others are for calibrations.
inline constexpr std::size_t kPartTests = 3;

inline constexpr double kTestTravel_deg = 2.0;
inline constexpr double kTestDuty_percent = 10.0;
inline constexpr double kSweepTop_deg = 30.0;
inline constexpr double kSweepStep_deg = 5.0;
inline constexpr double kRampTop_percent = 40.0;
inline constexpr double kRampSpeed_percent_s = 5.0;
inline constexpr double kChirp_s = 8.0;

/// Whether a test goes to a stretch that the operator gives.
[[nodiscard]] constexpr bool goesToStretch(DeviceTest test) {
  return test == DeviceTest::stretch || test == DeviceTest::chirp;
}

class TestMotion {
 public:
  /// @param motor_deg where the motors stand now, from the profile's zeros
  /// @param stretch_deg where `stretch` and `chirp` go; the others ignore it
  /// @return an error when an angle is no number or lies beyond the limit; a sweep ignores `motor_deg`
  [[nodiscard]] static Result<TestMotion> plan(DeviceTest test,
                                               const std::array<double, control::kMotorCount>& motor_deg,
                                               double motor_limit_deg, double stretch_deg = 0.0);

  [[nodiscard]] Duration length() const;
  /// The command at this time after the start; nothing before 0 and from `length` on: the motors are off then.
  [[nodiscard]] std::optional<control::MotorCommand> at(Duration since_start) const;
  /// Angles that `at` asks for, degrees.
  [[nodiscard]] std::array<double, control::kMotorCount> anglesAt(Duration since_start) const;
  /// Whether `anglesAt` has not changed for 0.3 s, so that the motors stand there.
  [[nodiscard]] bool restsAt(Duration since_start) const;
  /// Of breakaway and chirp: which experiment runs, from 1; 0: none. @see core/texture/felt/plant_sweep.h
  [[nodiscard]] int experimentAt(Duration since_start) const;
  [[nodiscard]] DeviceTest test() const { return test_; }

 private:
  DeviceTest test_ = DeviceTest::motor_1;
  std::array<double, control::kMotorCount> rest_deg_{};
  double travel_deg_ = 0.0;
  double stretch_deg_ = 0.0;
  double travel_s_ = 0.0;  ///< time of `stretch` and `chirp` to reach the stretch
  double length_s_ = 0.0;  ///< of the motion between the rests
};

}  // namespace fyd::device
