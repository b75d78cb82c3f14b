// Ranges of a surface model's values: what parseSurface accepts, and so what fitSurface may give.
#pragma once

namespace fyd::texture {

struct SurfaceRange {
  double minimum, maximum;
  [[nodiscard]] constexpr bool has(double value) const { return value >= minimum && value <= maximum; }
};

inline constexpr SurfaceRange kWavelengths_mm{0.01, 100.0}, kFrequencies_Hz{1.0, 5000.0}, kBandRms_g{0.0, 20.0};

}  // namespace fyd::texture
