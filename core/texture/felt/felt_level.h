// Level of a vibration at the finger, over what a finger feels.
#pragma once

namespace fyd::texture {

/// @param felt_g RMS of the acceleration at the finger
/// @return its level relative to kFeltThreshold_g in dB; −120 at least; NaN of NaN
[[nodiscard]] double feltLevel_dB(double felt_g);

}  // namespace fyd::texture
