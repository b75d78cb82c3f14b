#include "core/scene/contact/contact.h"

#include <cmath>
#include <optional>

#include "core/scene/contact/contact_facet.h"
#include "core/scene/contact/contact_nodes.h"
#include "core/scene/contact/contact_proxy.h"
#include "core/scene/contact/contact_vicinity.h"

namespace fyd::scene {
namespace {

constexpr double kNodesEdges = 3.0;      // default radius of the nodes' sphere: mean edges,
constexpr double kNodesDiagonal = 0.02;  // and not less than this share of the mesh's diagonal

/// A force with damping along the normal; its normal part is never a pull.
Vec3 damped(const Vec3& spring_N, const Vec3& normal, const Surface& surface, const Vec3& velocity_mm_s) {
  if (!(surface.damping_Ns_per_mm > 0.0) || !velocity_mm_s.finite()) return spring_N;
  const double along_N = dot(spring_N, normal);
  const double left_N = std::fmax(0.0, along_N - surface.damping_Ns_per_mm * dot(velocity_mm_s, normal));
  return spring_N + (left_N - along_N) * normal;
}

}  // namespace

struct BodyContact::Prepared {
  std::optional<EdgeKinds> edges;
  std::optional<FittedSurface> fitted;
  std::optional<ContactNodes> nodes;
  std::optional<ContactProxy> proxy;
};

BodyContact::BodyContact(const TriangleTree& tree, Surface surface, ContactSettings settings)
    : tree_(&tree), surface_(surface), settings_(settings) {
  const auto prepared = std::make_shared<Prepared>();
  const MeshReport& report = tree.mesh().report();
  const double diagonal_mm = length(report.highest_mm - report.lowest_mm);
  if (!(settings_.reach_mm > 0.0)) settings_.reach_mm = 0.5 * diagonal_mm;
  switch (settings_.model) {
    case ContactModel::nodes:
      if (!(settings_.radius_mm > 0.0)) {
        settings_.radius_mm = std::fmax(kNodesEdges * report.mean_edge_mm, kNodesDiagonal * diagonal_mm);
      }
      prepared->nodes.emplace(tree.mesh(), settings_.radius_mm);
      break;
    case ContactModel::facet: prepared->edges.emplace(tree.mesh()); break;
    case ContactModel::vicinity: prepared->fitted.emplace(tree.mesh()); break;
    case ContactModel::proxy: prepared->proxy.emplace(tree, settings_.radius_mm); break;
  }
  prepared_ = prepared;
}

Contact BodyContact::touch(const Vec3& probe_mm, const Vec3& velocity_mm_s, const Nearest& nearest) {
  Contact contact;
  contact.proxy_mm = probe_mm;
  if (!probe_mm.finite() || nearest.triangle == kNoTriangle) return contact;
  const auto take = [&](const Push& push) {
    if (!(push.depth_mm > 0.0) || push.depth_mm > settings_.reach_mm) return;
    contact.touching = true;
    contact.force_N =
        damped(surface_.stiffness_N_per_mm * push.force_over_stiffness_mm, push.normal, surface_, velocity_mm_s);
    contact.proxy_mm = push.point_mm;
    contact.normal = push.normal;
    contact.depth_mm = push.depth_mm;
    contact.stiffness_N_per_mm = surface_.stiffness_N_per_mm;
    contact.triangle = nearest.triangle;
  };
  switch (settings_.model) {
    case ContactModel::nodes: take(prepared_->nodes->push(probe_mm, nearest)); break;
    case ContactModel::facet: take(facetPush(tree_->mesh(), *prepared_->edges, probe_mm, nearest)); break;
    case ContactModel::vicinity: take(vicinityPush(*prepared_->fitted, probe_mm, nearest)); break;
    case ContactModel::proxy:
      if (std::optional<Contact> held = prepared_->proxy->step(probe_mm, nearest, surface_, state_)) {
        contact = *held;
        contact.force_N = damped(contact.force_N, contact.normal, surface_, velocity_mm_s);
      }
  }
  return contact;
}

std::size_t BodyContact::bytes() const {
  const Prepared& p = *prepared_;
  return sizeof(Prepared) + (p.edges ? p.edges->bytes() : 0) + (p.fitted ? p.fitted->bytes() : 0) +
         (p.nodes ? p.nodes->bytes() : 0);
}

}  // namespace fyd::scene
