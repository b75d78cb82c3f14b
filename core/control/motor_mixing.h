// Stretch and translation to the two motors, and back from their encoders.
//
//   first = stretch + translation,  second = translation − stretch        (degrees at the rollers)
//   stretch = (first − second)/2,   translation = (first + second)/2
//
// Turning in opposite senses stretches the cloth, in the same sense moves it sideways [thesis §3]. References are
// ticks, 4200 for 90°; encoders count 4096 a turn, with the profile's zeros and signs.
// Stability: may change
#pragma once

#include <array>
#include <cstdint>

#include "core/base/api.h"
#include "core/control/control_parameters.h"
#include "core/control/motor_types.h"

namespace fyd::control {

struct RollerAngles {
  double stretch_deg = 0.0;
  double translation_deg = 0.0;
  bool valid = false;  ///< false: a count above 4095; the angles are then 0
};

/// Encoder counts to angles in −180…180° around the profile's zeros: the zero may lie anywhere on the
/// 12-bit circle, a motor further than half a turn from it reads one turn off.
[[nodiscard]] FYD_API RollerAngles rollerAngles(const MotorFeedback& feedback, const ControlParameters& parameters);

/// Degrees to ticks, rounded, saturated at the int16 the boards take; NaN gives 0.
[[nodiscard]] FYD_API std::int16_t ticksFromDegrees(double angle_deg);

class FYD_API MotorMixing {
 public:
  explicit MotorMixing(const ControlParameters& parameters = {});
  void configure(const ControlParameters& parameters);

  /// Writes `command.reference_ticks`. The stretch comes first: when a motor would pass control.motor_limit_deg,
  /// the translation is reduced. A value that is not finite holds its last.
  void mix(double stretch_deg, double translation_deg, MotorCommand& command);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(stretch_deg_, translation_deg_);
  }

 private:
  double motor_limit_deg_ = 0.0;
  double stretch_deg_ = 0.0;
  double translation_deg_ = 0.0;
};

}  // namespace fyd::control
