// How many points of a soft body must be awake for an accuracy, found by pressing it.
// Stability: may change
#pragma once

#include <array>

#include "core/base/api.h"
#include "core/scene/soft/soft_body.h"

namespace fyd::scene {

struct SoftTrial {
  std::size_t most_points = 0;  ///< of SoftResolution: 1/16 to all of the points that a press wakes
  double mean_error = 0.0;      ///< of the force, as a share of the largest, against a press without that limit
};

struct SoftChoiceReport {
  SoftResolution chosen;
  bool met = false;  ///< whether the accuracy is; the most accurate is chosen otherwise
  double depth_mm = 0.0;
  std::array<SoftTrial, 5> trials;  ///< the cheapest first
};

/// Presses a few places to the depth of one newton, quickly, and then holds. Deterministic.
/// @return an error if SoftBody::build does not accept the material
[[nodiscard]] FYD_API Result<SoftChoiceReport> chooseSoft(const TriangleTree& tree, const SoftMaterial& material,
                                                          double accuracy);

}  // namespace fyd::scene
