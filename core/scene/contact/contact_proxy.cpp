#include "core/scene/contact/contact_proxy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/scene/mesh/vector.h"

namespace fyd::scene {
namespace {

constexpr std::size_t kMostWalls = 12;  // that hold the sphere at one place
constexpr int kMostTurns = 32;          // changes of direction in a step; the rest of the way is left to the next step
constexpr int kMostNewtonSteps = 60;
constexpr double kSameNormal = 1e-7;   // radians; walls whose normals differ by less count as one
constexpr double kLongestSlide = 1e6;  // radii, of a way along walls: kSameNormal over this way is less than the radius
constexpr double kFromBehind = -1e-9;  // cosine; a triangle met from behind does not hold the sphere
constexpr double kTowards = 5e-8;      // cosine; a neighbour that rises towards the sphere by less counts as level
constexpr int kMostFanTriangles = 256;  // triangles around a vertex that are checked
constexpr double kArrived = 1e-7;       // of the distance to the probe

struct Wall {
  Vec3 normal;                 // from the wall to the sphere's middle
  double least_advance = 0.0;  // a way must advance at least this far along the normal, mm
};

bool allowed(const Vec3& way, std::span<const Wall> walls, double slack) {
  return std::ranges::all_of(walls,
                             [&](const Wall& wall) { return dot(wall.normal, way) >= wall.least_advance - slack; });
}

/// Of the ways that all walls allow (half-spaces), the one nearest to `wanted`: tried are `wanted` itself, its
/// projection onto each wall and onto the edge of each two, and the corner of each three. Zero if there is none.
Vec3 closestAllowed(const Vec3& wanted, std::span<const Wall> walls, double slack) {
  if (allowed(wanted, walls, slack)) return wanted;
  Vec3 best;
  double nearest = std::numeric_limits<double>::infinity();
  const auto take = [&](const Vec3& way) {
    const double distance = squared(wanted - way);
    if (!(distance < nearest) || !allowed(way, walls, slack)) return;
    nearest = distance;
    best = way;
  };
  const auto missing = [&](const Wall& wall) { return wall.least_advance - dot(wall.normal, wanted); };
  for (const Wall& wall : walls) take(wanted + missing(wall) * wall.normal);
  if (nearest < std::numeric_limits<double>::infinity()) return best;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Vec3 &a = walls[i].normal, &b = walls[k].normal, both = a + b;
      const Vec3 edge = unit(cross(a, b)), straight = unit(edge - dot(edge, a) * a);
      const double out = std::max(walls[i].least_advance, walls[k].least_advance) * 2.0 / std::max(squared(both), 1e-6);
      take(dot(wanted, straight) * straight + out * both);
    }
  }
  if (nearest < std::numeric_limits<double>::infinity()) return best;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      for (std::size_t j = 0; j < k; ++j) {
        const Wall &a = walls[i], &b = walls[k], &c = walls[j];
        const Vec3 bc = cross(b.normal, c.normal), ca = cross(c.normal, a.normal), ab = cross(a.normal, b.normal);
        const double volume = dot(a.normal, bc);
        if (!(std::abs(volume) > 1e-9)) continue;
        take((1.0 / volume) * (a.least_advance * bc + b.least_advance * ca + c.least_advance * ab));
      }
    }
  }
  return best;
}

/// For a triangle that is touched at an edge or a vertex: the direction into an adjacent triangle that is nearer to the
/// sphere's middle, zero if there is none. The nearer triangle is then the one that holds the sphere; so the edges
/// within a flat face do not stop it.
/// @param from vector from the contact point to the sphere's middle
Vec3 towardsNearerNeighbour(const Mesh& mesh, const Nearest& q, const Vec3& from) {
  if (q.feature == Feature::inside) return {};
  const auto v = mesh.vertices();
  const double distance_mm = length(from);
  const auto nearer = [&](const Vec3& way) { return dot(from, way) > kTowards * distance_mm * length(way); };
  const auto opposite = [&](std::uint32_t t, std::uint32_t a, std::uint32_t b) {
    const Triangle& c = mesh.triangles()[t];
    return c[0] != a && c[0] != b ? c[0] : c[1] != a && c[1] != b ? c[1] : c[2];
  };
  const Triangle& own = mesh.triangles()[q.triangle];
  const auto which = static_cast<std::size_t>(q.feature);
  if (which >= 3) {
    const std::uint32_t a = own[which - 3], b = own[(which - 2) % 3];
    const std::uint32_t other = mesh.neighbours(q.triangle)[which - 3];
    if (other == kNoTriangle) return {};
    const Vec3 edge = v[b] - v[a], all = v[opposite(other, a, b)] - v[a];
    const Vec3 way = all - (dot(all, edge) / squared(edge)) * edge;
    return nearer(way) ? way : Vec3{};
  }
  const std::uint32_t corner = own[which];
  for (const std::size_t turn : {std::size_t{0}, std::size_t{2}}) {  // across the edge from the corner, to the corner
    std::uint32_t t = q.triangle;
    for (int i = 0; i < kMostFanTriangles; ++i) {
      const Triangle& c = mesh.triangles()[t];
      const std::size_t at = c[0] == corner ? 0 : c[1] == corner ? 1 : 2;
      const std::uint32_t other = mesh.neighbours(t)[(at + turn) % 3];
      if (other == kNoTriangle) break;
      if (other == q.triangle) return {};
      const Vec3 way = v[opposite(other, corner, c[(at + 1 + turn / 2) % 3])] - v[corner];
      if (nearer(way)) return way;
      t = other;
    }
  }
  return {};
}

}  // namespace

/// The triangles that a sphere can meet before its middle is farther than reach_mm from where it was: looked up once
/// for all changes of direction on its way. Sorted by distance, so that a search can end early.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): of `near` only the first `count` are read
struct ContactProxy::NearTriangles {
  struct Near {
    double gap_mm;  // between the sphere and the triangle, when looked up
    std::uint32_t triangle;
  };
  Vec3 middle_mm;
  double reach_mm = -1.0;
  std::array<Near, 256> near;
  std::size_t count = 0;

  void gather(const TriangleTree& tree, const Vec3& at_mm, double within_mm, double radius_mm) {
    middle_mm = at_mm;
    reach_mm = within_mm;
    count = 0;
    const Mesh& mesh = tree.mesh();
    bool all = true;
    tree.forEachNear(at_mm, at_mm, radius_mm + within_mm, [&](std::uint32_t t) {
      const double gap_mm = std::sqrt(nearestOnTriangle(mesh, at_mm, t).squared_mm2) - radius_mm;
      if (gap_mm > within_mm) return;
      all = all && count < near.size();
      if (all) near[count++] = {gap_mm, t};
    });
    if (!all) reach_mm = -1.0;
    std::sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), [](const Near& a, const Near& b) {
      return a.gap_mm < b.gap_mm || (a.gap_mm == b.gap_mm && a.triangle < b.triangle);
    });
  }
  [[nodiscard]] bool holds(const Vec3& at_mm) const {
    return reach_mm > 0.0 && squared(at_mm - middle_mm) < reach_mm * reach_mm;
  }
  /// @param each takes a triangle; @return how far from from_mm the sphere will go at most
  template <class Each>
  void forEachNear(const TriangleTree& tree, const Vec3& from_mm, const Vec3& to_mm, double distance_mm,
                   double rounding_mm, Each each) const {
    if (!holds(from_mm) || !holds(to_mm)) {
      return tree.forEachNear(from_mm, to_mm, distance_mm, [&](std::uint32_t t) { each(t); });
    }
    const double moved_mm = length(from_mm - middle_mm) + rounding_mm;
    double ahead_mm = length(to_mm - from_mm);
    for (std::size_t i = 0; i < count && near[i].gap_mm <= moved_mm + ahead_mm; ++i) {
      ahead_mm = std::min(ahead_mm, each(near[i].triangle));
    }
  }
};

struct ContactProxy::Walls {
  std::array<Wall, kMostWalls> wall;
  std::size_t count = 0;
  std::uint32_t triangle = kNoTriangle;

  void add(const Wall& added) {
    for (std::size_t i = 0; i < count; ++i) {
      if (squared(wall[i].normal - added.normal) > kSameNormal * kSameNormal) continue;
      wall[i].least_advance = std::max(wall[i].least_advance, added.least_advance);
      return;
    }
    if (count < kMostWalls) wall[count++] = added;
  }
  [[nodiscard]] std::span<const Wall> all() const { return {wall.data(), count}; }
};

ContactProxy::ContactProxy(const TriangleTree& tree, double radius_mm) : tree_(&tree) {
  const MeshReport& r = tree.mesh().report();
  double size_mm = 0.0;
  for (const Vec3& corner : {r.lowest_mm, r.highest_mm}) {
    size_mm = std::max({size_mm, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
  }
  smallest_radius_mm_ = 1e-7 * size_mm;
  rounding_mm_ = 1e-11 * size_mm;
  radius_mm_ = std::max(radius_mm, smallest_radius_mm_);
  middle_mm_ = 0.5 * (r.lowest_mm + r.highest_mm);
  far_mm_ = 4.0 * (size_mm + radius_mm_);
  near_margin_mm_ = 0.25 * r.mean_edge_mm;
}

ContactProxy::Walls ContactProxy::wallsAt(const NearTriangles& near_triangles, const Vec3& middle_mm,
                                          double radius_mm) const {
  Walls walls;
  const Mesh& mesh = tree_->mesh();
  const double touching_mm = radius_mm + rounding_mm_;
  const auto addIfTouched = [&](std::uint32_t t) {
    const Nearest q = nearestOnTriangle(mesh, middle_mm, t);
    if (!(q.squared_mm2 <= touching_mm * touching_mm)) return;
    const Vec3 from = middle_mm - q.point_mm, normal = mesh.triangleNormal(t);
    const double distance_mm = std::sqrt(q.squared_mm2);
    if (dot(from, normal) < kFromBehind * distance_mm || squared(towardsNearerNeighbour(mesh, q, from)) > 0.0) return;
    walls.add({distance_mm > 0.0 ? (1.0 / distance_mm) * from : normal, std::max(0.0, radius_mm - distance_mm)});
    walls.triangle = std::min(walls.triangle, t);
  };
  near_triangles.forEachNear(*tree_, middle_mm, middle_mm, touching_mm, 2.0 * rounding_mm_, [&](std::uint32_t t) {
    addIfTouched(t);
    return 0.0;
  });
  return walls;
}

ContactProxy::Hit ContactProxy::sweep(const NearTriangles& near_triangles, const Vec3& from_mm, const Vec3& way_mm,
                                      double radius_mm) const {
  const Mesh& mesh = tree_->mesh();
  const double whole_mm = length(way_mm);
  Hit hit;
  if (!(whole_mm > 0.0)) return hit;
  const Vec3 ahead = (1.0 / whole_mm) * way_mm;
  double first_mm = whole_mm;
  // Takes the triangle as the hit if the sphere meets it before first_mm. The distance to a triangle along a straight
  // way is a convex function: Newton's steps from before the hit do not go past it.
  const auto findHit = [&](std::uint32_t t) {
    double at_mm = 0.0;
    for (int i = 0; i < kMostNewtonSteps; ++i) {
      const Vec3 middle_mm = from_mm + at_mm * ahead;
      const Nearest q = nearestOnTriangle(mesh, middle_mm, t);
      const double distance_mm = std::sqrt(q.squared_mm2), gap_mm = distance_mm - radius_mm;
      const Vec3 from = middle_mm - q.point_mm;
      const double nearing = -dot(from, ahead);  // times the distance
      if (!(nearing > 0.0)) return;
      if (gap_mm <= 0.5 * rounding_mm_) {
        // The way leads into a triangle that holds the sphere at its beginning only by rounding.
        if (at_mm == 0.0 && nearing * whole_mm <= (rounding_mm_ + 2.0 * kSameNormal * whole_mm) * distance_mm) return;
        if (dot(from, mesh.triangleNormal(t)) < kFromBehind * distance_mm) return;
        const Vec3 other = towardsNearerNeighbour(mesh, q, from);
        if (squared(other) == 0.0) break;
        // Another triangle holds the sphere here; this one may do so farther on.
        const double leaving = -dot(other, ahead);
        if (!(leaving > 0.0)) return;
        at_mm += dot(from, other) / leaving;
        if (!(at_mm < first_mm)) return;
        continue;
      }
      at_mm += gap_mm * distance_mm / nearing;
      if (!(at_mm < first_mm)) return;
    }
    first_mm = at_mm;
    hit = {at_mm / whole_mm, t};
  };
  double done_mm = 0.0, piece_mm = 0.9 * near_margin_mm_;  // a long way is swept in pieces of growing length
  while (hit.triangle == kNoTriangle && done_mm < whole_mm) {
    const double next_mm = std::min(whole_mm, done_mm + piece_mm);
    near_triangles.forEachNear(*tree_, from_mm + done_mm * ahead, from_mm + next_mm * ahead, radius_mm + rounding_mm_,
                               2.0 * rounding_mm_, [&](std::uint32_t t) {
                                 findHit(t);
                                 return first_mm - done_mm;
                               });
    done_mm = next_mm;
    piece_mm *= 4.0;
  }
  return hit;
}

Vec3 ContactProxy::advanceToMesh(const Vec3& from_mm, const Vec3& goal_mm) const {
  const Vec3 from = from_mm - middle_mm_, wanted = goal_mm - from_mm;
  const double whole_mm = length(wanted), away_mm = length(from);
  if (!(away_mm > far_mm_) || !(whole_mm > 0.0)) return from_mm;
  const Vec3 ahead = (1.0 / whole_mm) * wanted;
  const double to_nearest_mm = -dot(from, ahead);
  if (!(length(from + to_nearest_mm * ahead) < 0.5 * far_mm_)) return goal_mm;
  return from_mm + std::clamp(to_nearest_mm - 0.9 * far_mm_, 0.0, whole_mm) * ahead;
}

ContactProxy::Place ContactProxy::moveTowards(const Vec3& from_mm, const Vec3& goal_mm, double radius_mm) const {
  Place place{advanceToMesh(from_mm, goal_mm)};
  NearTriangles near_triangles;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    // Looked up again once the sphere has moved by a third of the last look-up's reach.
    if (!near_triangles.holds(place.middle_mm + 2.0 * (place.middle_mm - near_triangles.middle_mm))) {
      near_triangles.gather(*tree_, place.middle_mm, near_margin_mm_, radius_mm + rounding_mm_);
    }
    Vec3 wanted = goal_mm - place.middle_mm;
    double left_mm = length(wanted);
    if (!(left_mm > 0.0)) break;
    const Walls walls = wallsAt(near_triangles, place.middle_mm, radius_mm);
    // The way is limited so that its rounding error stays below rounding_mm_.
    if (walls.count > 0 && left_mm > far_mm_) {
      wanted = (far_mm_ / left_mm) * wanted;
      left_mm = far_mm_;
    }
    Vec3 way = closestAllowed(wanted, walls.all(), 0.1 * rounding_mm_);
    const bool straight = way == wanted;
    if (const double slide_mm = length(way); walls.count > 0 && slide_mm > kLongestSlide * radius_mm) {
      way = (kLongestSlide * radius_mm / slide_mm) * way;
    }
    place.held = !straight;
    place.triangle = straight ? kNoTriangle : walls.triangle;
    if (!(length(way) > kArrived * left_mm + rounding_mm_)) break;
    const Hit hit = sweep(near_triangles, place.middle_mm, way, radius_mm);
    if (hit.triangle == kNoTriangle) {
      place.middle_mm = way == goal_mm - place.middle_mm ? goal_mm : place.middle_mm + way;
    } else {
      place.middle_mm = place.middle_mm + hit.share * way;
      place.held = true;
      place.triangle = hit.triangle;
    }
  }
  return place;
}

std::optional<Contact> ContactProxy::step(const Vec3& probe_mm, const Nearest& nearest, const Surface& surface,
                                          ContactState& state) const {
  const Mesh& mesh = tree_->mesh();
  if (!state.placed) state = {probe_mm, probe_mm, 0.0, true, false, false};
  const double radius_mm = std::max(state.radius_mm, smallest_radius_mm_);
  // `free`: where the proxy would be without friction.
  const Place free = moveTowards(state.free_mm, probe_mm, radius_mm);
  const Vec3 pull_mm = free.middle_mm - probe_mm;
  const double depth_mm = length(pull_mm);
  if (!free.held || !(depth_mm > rounding_mm_)) {
    const bool outside = nearest.triangle != kNoTriangle &&
                         dot(probe_mm - nearest.point_mm, mesh.normalOf(nearest.triangle, nearest.feature)) > 0.0;
    // Nothing is touched: the sphere grows again to the finger's radius, as far as it fits.
    const double room_mm = outside ? std::min(std::sqrt(nearest.squared_mm2), radius_mm_) : 0.0;
    state = {free.middle_mm, free.middle_mm, free.held ? state.radius_mm : room_mm, true, false, false};
    return std::nullopt;
  }
  const Vec3 normal = (1.0 / depth_mm) * pull_mm;
  Place place = free;
  if (state.touching && surface.static_friction > 0.0) {
    // Friction cone: tangential pull over normal pull is moved over depth.
    const Vec3 moved = free.middle_mm - state.proxy_mm;
    const double moved_mm = length(moved);
    const double coefficient = state.sliding ? surface.kinetic_friction : surface.static_friction;
    if (moved_mm <= coefficient * depth_mm) {
      place = {state.proxy_mm, true, free.triangle};
      state.sliding = false;
    } else {
      // It slides until the tangential pull is the kinetic share of the normal pull.
      const double behind_mm = std::min(surface.kinetic_friction, coefficient) * depth_mm;
      place = moveTowards(state.proxy_mm, probe_mm - (behind_mm / moved_mm) * moved, radius_mm);
      state.sliding = true;
    }
  }
  state.proxy_mm = place.middle_mm;
  state.free_mm = free.middle_mm;
  state.touching = true;
  Contact contact;
  contact.touching = true;
  contact.force_N = surface.stiffness_N_per_mm * (place.middle_mm - probe_mm);
  contact.proxy_mm = place.middle_mm;
  contact.normal = normal;
  contact.depth_mm = depth_mm;
  contact.stiffness_N_per_mm = surface.stiffness_N_per_mm;
  contact.triangle = free.triangle;
  return contact;
}

}  // namespace fyd::scene
