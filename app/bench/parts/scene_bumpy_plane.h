// The test surface of the contact benches: z = A sin(kx) sin(ky), and a probe that moves under it.
#pragma once

#include <vector>

#include "core/scene/mesh/mesh.h"

namespace fyd::bench {

inline constexpr double kBumps_mm = 2.0;
inline constexpr double kBumpLength_mm = 20.0;
inline constexpr double kPlane_mm = 100.0;

/// 2 n² triangles.
[[nodiscard]] scene::TriangleSoup bumpyPlane(int n);

/// Its unit normal, and its height.
[[nodiscard]] Vec3 bumpyNormal(double x_mm, double y_mm);
[[nodiscard]] double bumpyHeight(double x_mm, double y_mm);

/// Steps of 1 ms of a probe `depth_mm` under the surface along its normal.
[[nodiscard]] std::vector<Vec3> underBumpyPlane(int steps, double speed_mm_s, double depth_mm);

}  // namespace fyd::bench
