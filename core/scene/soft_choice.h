// How much of a soft body must be awake for an accuracy, found by pressing it.
#pragma once

#include <array>

#include "core/scene/scene_description.h"
#include "core/scene/soft_body.h"

namespace fyd::scene {

struct SoftTrial {
  double border = 0.0;      ///< as of SoftResolution
  double mean_error = 0.0;  ///< of the force, as a share of that with all points awake
  double awake = 0.0;       ///< points, mean of the presses
};

struct SoftChoiceReport {
  SoftResolution chosen;
  bool met = false;  ///< whether the accuracy is; the most accurate is chosen otherwise
  double depth_mm = 0.0;
  std::array<SoftTrial, 5> trials;  ///< the cheapest first
};

/// Presses a few places as deep as one newton, quickly and then at rest. Deterministic.
/// @param body whose material SoftBody::build accepts
[[nodiscard]] Result<SoftChoiceReport> chooseSoft(const TriangleTree& tree, const SoftMaterial& material,
                                                  double accuracy);

}  // namespace fyd::scene
