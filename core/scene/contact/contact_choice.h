// Which contact model a mesh needs, found by touching it.
//
// A mesh samples a surface at its vertices. At a few hundred places spread over it each model computes the force of a
// haptic point at the depth that gives one newton. It is compared with that of the fitted surface (vicinity), the best
// estimate of the true one. The fit's own error is found by leaving out one vertex at a time: the force there, by the
// fit to the mesh without it, is compared with that of the whole mesh. That error belongs to a mesh of twice the edge
// length; half of it is taken, though a fit of third order gains more. With e the true error on spheres, bumps and
// cylinders, the error reported for facet and vicinity is between 0.9 e and 2.5 e + 2e-4; a numerical test holds it to
// that.
//
// In a wall thinner than that depth the nearest surface may be the one behind: facet, vicinity and nodes would push the
// point through, and only a proxy holds it. These places are counted too.
// Stability: may change
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/base/api.h"
#include "core/scene/contact/contact.h"

namespace fyd::scene {

/// What a model did on a mesh.
struct ModelTrial {
  ContactModel model = ContactModel::facet;
  double mean_error = 0.0;  ///< of the force, as a share of it
  double pushes_through =
      0.0;  ///< share of the places where it does not touch or pushes on inwards: it is beyond the wall
};

struct ContactChoiceReport {
  ContactModel chosen = ContactModel::vicinity;
  bool met = false;       ///< whether the accuracy is; the most accurate is chosen otherwise
  double depth_mm = 0.0;  ///< of the trial's haptic points
  std::size_t places = 0;
  std::array<ModelTrial, 4> trials;  ///< the cheapest first
};

/// Deterministic: the same mesh gives the same choice on every machine. Cost is by rank, facet, vicinity, proxy, nodes,
/// as it is on meshes of every size (`fyd bench scene_contact`).
/// @param accuracy largest mean error of the force, as a share
[[nodiscard]] FYD_API ContactChoiceReport chooseContact(const TriangleTree& tree, const Surface& surface,
                                                        const ContactSettings& settings, double accuracy);

}  // namespace fyd::scene
