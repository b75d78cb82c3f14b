// What a body's surface is made of: how it pushes back and rubs.
// Stability: stable since 0.1
#pragma once

namespace fyd::scene {

struct Surface {
  double stiffness_N_per_mm = 0.5;  ///< 1e-6 … 1e4
  double damping_Ns_per_mm = 0.0;   ///< against motion along the normal while touching; ≥ 0
  double static_friction = 0.0;     ///< of the normal force, before it slides; ≥ 0; of the proxy only
  double kinetic_friction = 0.0;    ///< of the normal force, while it slides; 0 … static_friction
};

}  // namespace fyd::scene
