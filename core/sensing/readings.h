// Raw readings of the touchpad, as its interfaces deliver them and as the step takes them.
// Counts stay counts here: turning them into millimetres and newtons is sensing's work, with the profile's calibration.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/batch.h"

namespace fyd::sensing {

/// IR distance sensors the house can carry (the touchpad of the thesis has three).
inline constexpr std::size_t kMaximumIrSensors = 8;

/// 12-bit ADC codes, 0…4095, in the profile's sensor order (thesis §4.1.2).
using IrCounts = Batch<std::uint16_t, kMaximumIrSensors>;

/// Load-cell bridge (thesis §4.1.3).
struct BridgeReading {
  double value_mV_per_V = 0.0;
};

}  // namespace fyd::sensing
