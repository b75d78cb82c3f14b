// The force of a rigid body on a haptic point.
//
// Four models. With k the stiffness, p the probe and d its depth:
//   nodes     the vertices within a sphere of radius R around the probe push back
//   facet     k·d along the normal of the nearest triangle, F = −K·X
//   vicinity  k·d along the normal, both of a smooth surface fitted to the vertices around
//   proxy     a sphere that stays outside, pulled by the probe with k; static and kinetic friction
// In all of them damping acts along the normal while touching, and the normal force never pulls.
//
// nodes, facet and vicinity have no state; the proxy's is ContactState. No time step enters: the force depends on the
// probe's present and former positions and on its velocity, not on the rate of the steps.
// Stability: may change
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>

#include "core/base/api.h"
#include "core/scene/contact/contact_state.h"
#include "core/scene/contact/surface.h"
#include "core/scene/mesh/triangle_tree.h"

namespace fyd::scene {

enum class ContactModel : std::uint8_t { nodes, facet, vicinity, proxy };
inline constexpr std::array<std::string_view, 4> kContactModels = {"nodes", "facet", "vicinity", "proxy"};

struct ContactSettings {
  ContactModel model = ContactModel::vicinity;
  /// proxy: of the finger; 0 is a point. nodes: of the sphere; 0: three mean edges, at least 2 % of the mesh's
  /// diagonal.
  double radius_mm = 0.0;
  /// nodes, facet, vicinity: the depth beyond which there is no force. 0: half of the mesh's diagonal, which no point
  /// within a closed body exceeds.
  double reach_mm = 0.0;
};

/// One body and one haptic point that touches it.
class FYD_API BodyContact {
 public:
  /// Computes what the model needs of the mesh; copies share it. @param tree must outlive this
  BodyContact(const TriangleTree& tree, Surface surface, ContactSettings settings);

  /// One step; allocates nothing. @param nearest the point of the mesh that is nearest to the probe
  /// (TriangleTree::nearest, NearestPoint::find). A probe that is not finite touches nothing and is not remembered.
  [[nodiscard]] Contact touch(const Vec3& probe_mm, const Vec3& velocity_mm_s, const Nearest& nearest);

  /// For continuing later from the present state, bit for bit.
  [[nodiscard]] const ContactState& state() const { return state_; }
  void restore(const ContactState& state) { state_ = state; }
  template <class Archive>
  void serialize(Archive& archive) {
    archive(state_);
  }

  [[nodiscard]] const Surface& surface() const { return surface_; }
  /// With values in place of the zeros that stand for defaults.
  [[nodiscard]] const ContactSettings& settings() const { return settings_; }
  /// Memory in use, without mesh and tree.
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Prepared;

  const TriangleTree* tree_;
  Surface surface_;
  ContactSettings settings_;
  std::shared_ptr<const Prepared> prepared_;
  ContactState state_;
};

}  // namespace fyd::scene
