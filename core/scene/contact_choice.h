// Which contact model a mesh needs, found by touching it.
//
// A mesh stands for a surface of which it knows only the vertices. At a few hundred places spread over it each model is
// asked for the force of a haptic point as deep as one newton, and compared with the fitted surface (vicinity), the
// nearest to the truth that there is. How near that itself is shows where vertices are left out: the fit around the gap
// is asked for the force at the vertex that it has not seen. Its error there belongs to a mesh of twice the edge; half
// of it is taken, though a fit of third order gains more. On spheres, bumps and cylinders the error said so is 0.95 to
// 1.3 times the true one for facet, 1.2 to 3.4 times for vicinity (tests/numerics/scene/choice_test.cpp).
//
// In a wall thinner than that depth the nearest surface may be the one behind: facet, vicinity and nodes would push
// through, and only a proxy holds. That is counted too.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/scene/contact.h"

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
  double depth_mm = 0.0;  ///< at which was touched
  std::size_t places = 0;
  std::array<ModelTrial, 4> trials;  ///< the cheapest first
};

/// Deterministic: the same mesh gives the same choice on every machine. Cost is by rank, facet, vicinity, proxy, nodes,
/// as it is on meshes of every size (`fyd bench scene_contact`).
/// @param accuracy largest mean error of the force, as a share
[[nodiscard]] ContactChoiceReport chooseContact(const TriangleTree& tree, const Surface& surface,
                                                const ContactSettings& settings, double accuracy);

}  // namespace fyd::scene
