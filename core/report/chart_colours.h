// One colour for each quantity, on paper and in the light window: colour-blind-safe (after Okabe and Ito), darkened.
// 0xRRGGBB.
#pragma once

#include <cstdint>

namespace fyd::report {

using Rgb = std::uint32_t;

inline constexpr Rgb kForceRgb = 0x0072b2;
inline constexpr Rgb kIndentationRgb = 0xa33d7d;
inline constexpr Rgb kStiffnessRgb = 0x007a58;
inline constexpr Rgb kVibrationRgb = 0x7d6c00;
inline constexpr Rgb kTextRgb = 0x14181c;
inline constexpr Rgb kMutedRgb = 0x55606a;
inline constexpr Rgb kLineRgb = 0xc9cfd5;
inline constexpr Rgb kDangerRgb = 0xc6202c;  ///< stops, holds, lost samples only

}  // namespace fyd::report
