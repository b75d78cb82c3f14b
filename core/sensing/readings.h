// Raw readings of the touchpad, as its interfaces deliver them and as the step takes them.
// Counts stay counts here: turning them into millimetres and newtons is sensing's work, with the profile's calibration.
// Stability: stable since 0.1
#pragma once

#include <array>
#include <cstdint>

#include "core/base/fields.h"

namespace fyd::sensing {

/// Largest number of IR distance sensors of a touchpad (the thesis' has three).
inline constexpr std::size_t kMaximumIrSensors = 8;

/// Codes of the distance sensors [thesis §4.1.2].
using IrCounts = Batch<std::uint16_t, kMaximumIrSensors>;

/// Load-cell bridge [thesis §4.1.3].
struct BridgeReading {
  double value_mV_per_V = 0.0;

  static constexpr auto fields() {
    return std::tuple(
        Field("value_mV_per_V", "mV/V", "of the load cell's bridge, not calibrated", &BridgeReading::value_mV_per_V));
  }
};

}  // namespace fyd::sensing

template <>
inline constexpr auto fyd::kFieldsOf<fyd::sensing::IrCounts> =
    std::tuple(fyd::Field("counts", "ADC code", "12 bit, 0 to 4095, in the profile's order of sensors", std::identity())
                   .counted("sensors"));
