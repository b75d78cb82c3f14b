// Plant model from a duty to the finger: motors, rollers, and the cloth with the finger on it.
//
//   motor   breakaway friction, then a first-order lag to the free speed
//   board   its own proportional position loop: opposing duty in % per degree
//   roller  moves the cloth sideways at its radius
//   cloth   couples the finger by a spring and a damper: a second-order resonance that depends on the stretch
//
// The constants are found by identification. Until then the defaults apply, the middle of the
// plausible range, and `identified` is false.
// Stability: may change
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/api.h"
#include "core/base/error.h"
#include "core/base/message.h"

namespace fyd::texture {

inline constexpr std::size_t kFeltMotors = 2;
/// Perception threshold of a finger for vibration, RMS.
inline constexpr double kFeltThreshold_g = 0.02;

struct FYD_API FeltPlant {
  bool identified = false;
  std::array<double, kFeltMotors> breakaway_percent{15.0, 15.0};
  double free_speed_deg_s = 207.0;
  double time_constant_ms = 15.0;
  double position_gain_percent_per_deg = 25.0;
  double roller_radius_mm = 10.0;
  double cloth_gain = 1.0;
  double resonance_Hz = 70.0;
  double damping = 0.3;
  double stretch_deg = 45.0;
  double resonance_Hz_per_deg = 0.0;

  /// Resonance at this stretch; within 10…400 Hz. NaN counts as stretch_deg.
  [[nodiscard]] double resonanceAt_Hz(double stretch_deg) const;
  /// Angular acceleration of a roller that moves the cloth with 1 g, °/s² per g.
  [[nodiscard]] double rollerAccelerationPerG_deg_s2() const;

  template <class Visitor>
  void describe(Visitor& v) {
    v.boolean("texture.plant_identified", identified,
              {.help = sentence("Whether the way to the finger was identified; the constants below are guesses "
                                "otherwise.")});
    v.real("texture.plant_breakaway_first_percent", breakaway_percent[0],
           {.unit = "%",
            .minimum = 0.1,
            .maximum = 60,
            .help = sentence("Duty that the first motor needs before it turns.")});
    v.real("texture.plant_breakaway_second_percent", breakaway_percent[1],
           {.unit = "%",
            .minimum = 0.1,
            .maximum = 60,
            .help = sentence("Duty that the second motor needs before it turns.")});
    v.real("texture.plant_free_speed_deg_s", free_speed_deg_s,
           {.unit = "°/s",
            .minimum = 10,
            .maximum = 5000,
            .help = sentence("Speed of the roller at full duty without load.")});
    v.real("texture.plant_time_constant_ms", time_constant_ms,
           {.unit = "ms",
            .minimum = 1,
            .maximum = 200,
            .help = sentence("Time in which a motor reaches 63 % of its speed.")});
    v.real("texture.plant_position_gain", position_gain_percent_per_deg,
           {.unit = "%/°",
            .minimum = 0,
            .maximum = 200,
            .help = sentence("Duty with which the board's own position loop answers a degree.")});
    v.real("texture.plant_roller_radius_mm", roller_radius_mm,
           {.unit = "mm", .minimum = 1, .maximum = 100, .help = sentence("Radius of the rollers, cloth included.")});
    v.real("texture.plant_cloth_gain", cloth_gain,
           {.minimum = 0.05,
            .maximum = 5,
            .help = sentence("Acceleration of the finger over that of the rollers, far below the resonance.")});
    v.real("texture.plant_resonance_Hz", resonance_Hz,
           {.unit = "Hz",
            .minimum = 10,
            .maximum = 400,
            .help = sentence("Resonance of the cloth with a finger on it, at the stretch below.")});
    v.real("texture.plant_damping", damping,
           {.minimum = 0.02, .maximum = 2, .help = sentence("Damping ratio of that resonance.")});
    v.real("texture.plant_stretch_deg", stretch_deg,
           {.unit = "°", .minimum = 0, .maximum = 120, .help = sentence("Stretch at which the resonance was found.")});
    v.real("texture.plant_resonance_Hz_per_deg", resonance_Hz_per_deg,
           {.unit = "Hz/°",
            .minimum = -5,
            .maximum = 5,
            .help = sentence("How much a degree of stretch moves the resonance.")});
  }

  friend bool operator==(const FeltPlant&, const FeltPlant&) = default;
};

/// Its text form, plant.toml: the names above without "texture.plant_", but `breakaway_percent`, which is one number
/// for both motors or a list of two. Required: breakaway_percent, free_speed_deg_s, time_constant_ms, roller_radius_mm,
/// resonance_Hz, damping. What is read counts as identified unless `identified = false`.
/// @param unknown when given: receives the keys that this program does not know
/// @return an error with source, line, key, value and what was expected
[[nodiscard]] FYD_API Result<FeltPlant> parsePlant(std::string_view text, std::string_view source_name,
                                                   std::vector<std::string>* unknown = nullptr);
/// Text that parsePlant reads back equal.
[[nodiscard]] FYD_API std::string formatPlant(const FeltPlant& plant);

}  // namespace fyd::texture
