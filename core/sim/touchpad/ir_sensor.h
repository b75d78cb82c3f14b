// One simulated Sharp distance sensor with its 12-bit converter: the inverse of the thesis' curve
// (sensing/ir_distance.h), over the whole range of the converter. A profile's calibration does not change this curve.
#pragma once

#include <array>
#include <cstdint>

namespace fyd::sim {

struct SensorPlace {
  double x_mm = 0.0;
  double y_mm = 0.0;
};

/// Places on the cloth that the three sensors measure, from the camera's axis [thesis §4.1.2].
inline constexpr std::array<SensorPlace, 3> kIrPlaces = {{{-22.0, -3.0}, {0.0, 27.0}, {22.0, -3.0}}};

/// Voltage at a distance; the curve falls strictly, so there is one. Clamped to the converter's range; NaN gives 0 V.
[[nodiscard]] double irVolts(double distance_mm);

/// The converter's code for a voltage; NaN gives 0.
[[nodiscard]] std::uint16_t irCode(double volts);

}  // namespace fyd::sim
