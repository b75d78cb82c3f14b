// What a soft body is made of, in quantities that do not depend on its mesh.
//
// The paper's material points are heavy, elastic and viscous. Here they are a sampling of a continuous surface: a
// membrane with the tension T [N/mm] on a foundation of k [N/mm³], so that a rest load p [N/mm²] displaces it by u with
// k·u − T·∇²u = p. A vertex then has a spring to its rest position of k times its area (the paper's rigidity to the
// rest place) and springs to its neighbours of T times the edge's cotangent weight (its rigidity between points). Under
// a press at a mathematical point the depth would grow without bound as the mesh gets finer, so a press always has the
// radius of a finger.
// Stability: may change
#pragma once

#include "core/base/api.h"
#include "core/base/error.h"

namespace fyd::scene {

/// The paper's mass, rigidity and viscosity, and how far a press spreads.
struct SoftMaterial {
  double mass_kg = 0.01;             ///< ≥ 0. Of the whole surface, spread evenly
  double rigidity_N_per_mm = 0.5;    ///< > 0. Force over depth of a slow press on a wide flat piece
  double viscosity_Ns_per_mm = 0.0;  ///< ≥ 0. Force over speed of that press that is added while it moves
  double spread_mm = 3.0;  ///< ≥ 0. √(T/k): beyond the finger, displacement falls to 1/e in about this length
  double finger_mm = 2.0;  ///< > 0. Radius of the patch on which a press acts, with (1 − r²/radius²)²
};

/// Coefficients of the continuous surface.
struct SoftSurface {
  double foundation_N_per_mm3 = 0.0;
  double tension_N_per_mm = 0.0;
  double relaxation_s = 0.0;      ///< viscosity over rigidity: viscous forces are the elastic ones of u' times this
  double mass_Ns2_per_mm3 = 0.0;  ///< per area
};

/// @return an error that names what is out of range
[[nodiscard]] FYD_API Result<SoftMaterial> checked(const SoftMaterial& material);

/// Depth [mm] of 1 N pressed with `finger_mm` on a wide flat piece of foundation 1 N/mm³ and that spread; the depth is
/// the mean with the finger's weights. From the equation above on rings around the press, solved directly.
[[nodiscard]] FYD_API double depthOfUnitPress(double finger_mm, double spread_mm);

/// @param material as returned by `checked`  @param area_mm2 of the whole body
[[nodiscard]] FYD_API SoftSurface surfaceOf(const SoftMaterial& material, double area_mm2);

}  // namespace fyd::scene
