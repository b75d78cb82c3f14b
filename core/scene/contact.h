// The force of a rigid body on a haptic point.
//
// Four models. With k the stiffness, p the probe and d its depth:
//   nodes     the vertices that a sphere of radius R around the probe has met on its way in push back (contact_nodes.h)
//   facet     k·d along the normal of the nearest triangle, F = −K·X (contact_facet.h)
//   vicinity  k·d along the normal, both of a smooth surface fitted to the vertices around (contact_vicinity.h)
//   proxy     a sphere that stays outside, pulled by the probe with k; static and kinetic friction (contact_proxy.h)
// In all of them damping acts along the normal while touching, and the normal force never pulls.
//
// nodes, facet and vicinity know nothing of the step before; the proxy's memory is ContactState. No time step enters:
// the force depends on where the probe is and was, and on its velocity, not on how often it is asked.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>

#include "core/scene/surface.h"
#include "core/scene/triangle_tree.h"

namespace fyd::scene {

enum class ContactModel : std::uint8_t { nodes, facet, vicinity, proxy };
inline constexpr std::array<std::string_view, 4> kContactModels = {"nodes", "facet", "vicinity", "proxy"};

struct ContactSettings {
  ContactModel model = ContactModel::vicinity;
  /// proxy: of the finger, 0 is a point. nodes: of the sphere; 0: three mean edges.
  double radius_mm = 0.0;
  /// facet, vicinity: deeper there is no force. 0: half of the mesh's diagonal, which no point within a closed body
  /// exceeds.
  double reach_mm = 0.0;
};

struct Contact {
  bool touching = false;
  Vec3 force_N;   ///< on the probe
  Vec3 proxy_mm;  ///< the point of the surface that is touched (proxy: the middle of its sphere); the probe if none is
  Vec3 normal;    ///< of unit length, outwards; zero if nothing is touched
  double depth_mm = 0.0;
  double stiffness_N_per_mm = 0.0;  ///< at the contact; 0 if nothing is touched
  std::uint32_t triangle = kNoTriangle;
};

/// All that a model remembers from step to step.
struct ContactState {
  template <class Archive>
  void serialize(Archive& archive) {
    archive(proxy_mm, free_mm, radius_mm, placed, touching, sliding);
  }

  Vec3 proxy_mm;
  Vec3 free_mm;            ///< where the proxy would be without friction
  double radius_mm = 0.0;  ///< as much of the finger's radius as had room
  bool placed = false;     ///< proxy_mm has a value
  bool touching = false;
  bool sliding = false;
};

/// One body and one haptic point that touches it.
class BodyContact {
 public:
  /// What the model needs of the mesh is computed here. @param tree must outlive this
  /// Copies share it.
  BodyContact(const TriangleTree& tree, Surface surface, ContactSettings settings);

  /// One step; allocates nothing. @param nearest the point of the mesh that is nearest to the probe
  /// (TriangleTree::nearest, NearestPoint::find). A probe that is not finite touches nothing and is not remembered.
  [[nodiscard]] Contact touch(const Vec3& probe_mm, const Vec3& velocity_mm_s, const Nearest& nearest);

  /// To go on later from where it stands now, to the bit.
  [[nodiscard]] const ContactState& state() const { return state_; }
  void restore(const ContactState& state) { state_ = state; }
  template <class Archive>
  void serialize(Archive& archive) {
    archive(state_);
  }

  [[nodiscard]] const Surface& surface() const { return surface_; }
  /// With the defaults filled in.
  [[nodiscard]] const ContactSettings& settings() const { return settings_; }
  /// Of memory, beside mesh and tree.
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
