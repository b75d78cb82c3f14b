#include "core/scene/mesh/nearest_point.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <system_error>
#include <thread>

#include "core/base/portable_math.h"
#include "core/scene/mesh/vector.h"

namespace fyd::scene {
namespace {

constexpr double kMostEdges = 10.0;  // mean edges: the largest radius of a certificate
/// A triangle at a vertex with more triangles has no certificate: checking all of them would be slower than the tree.
constexpr std::size_t kLargestFan = 64;
constexpr std::size_t kAtATime = 1024;  // triangles that a thread takes at a time
constexpr int kMostMoves = 64;          // of a walk; for a probe that moved farther the tree is searched
/// A foot this near to an edge (as a share of the triangle) is compared with what lies across it: rounding may put it
/// on either side.
constexpr double kAtEdge = 1e-6;
/// 0, 2^(n/8) from 2^−16 to 2^16, and infinite.
constexpr std::array<float, 256> quantisationLevels() {
  std::array<float, 256> out{};
  double eighth = 1.0;
  for (std::size_t i = 0; i < 8; ++i, eighth *= 1.0905077326652577) {
    for (std::size_t octave = 0; octave < 32; ++octave) {
      const double power = octave < 16 ? 1.0 / (1 << (16 - octave)) : 1 << (octave - 16);
      out[8 * octave + i] = static_cast<float>(eighth * power);
    }
  }
  out.front() = 0.0F;
  out.back() = std::numeric_limits<float>::infinity();
  return out;
}

}  // namespace

constexpr std::array<float, 256> WalkableMesh::kLevels = quantisationLevels();

WalkableMesh::WalkableMesh(const TriangleTree& tree) : tree_(&tree), fans_(tree.mesh()) {
  const std::size_t count = mesh().triangles().size();
  links_.resize(count);
  for (auto& side : sides_) side.resize(count);
  // A triangle's certificate does not depend on the thread or the order.
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t from; (from = next.fetch_add(kAtATime)) < count;) {
      for (std::size_t t = from; t < std::min(count, from + kAtATime); ++t) certify(static_cast<std::uint32_t>(t));
    }
  };
  std::vector<std::jthread> helpers;
  const std::size_t most = std::min<std::size_t>(std::thread::hardware_concurrency(), count / (4 * kAtATime));
  try {
    while (helpers.size() + 1 < most) helpers.emplace_back(work);
  } catch (const std::system_error&) {  // no more threads: it takes longer
  }
  work();
}

void WalkableMesh::certify(std::uint32_t triangle) {
  const Triangle& corners = mesh().triangles()[triangle];
  links_[triangle] = {corners, mesh().neighbours(triangle)};
  if (std::any_of(corners.begin(), corners.end(), [this](std::uint32_t v) { return fans_[v].size() > kLargestFan; })) {
    return;
  }
  const double edge_mm = mesh().report().mean_edge_mm;
  const auto empty_mm = tree_->emptyBalls_mm(triangle, kMostEdges * edge_mm);
  for (std::size_t side = 0; side < 2; ++side) {
    const auto* const above = std::upper_bound(kLevels.begin(), kLevels.end(), empty_mm[side] / edge_mm);
    sides_[side][triangle].empty = static_cast<Side::Quantised>(above - kLevels.begin() - 1);
  }
  checkVertexNeighbours(triangle);
}

namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

/// How far (times the ball's radius) from an edge a ball must touch a triangle T so as to hold nothing of a triangle U
/// that shares one vertex with it. With the vertex in the origin, in T's plane: T's edges a, b and U's p, q, both
/// turning counter-clockwise; `slope`: the largest rise of U over T's plane on its way from the vertex.
///
/// A point of U at the distance s from the vertex rises by s·slope at most. Seen from the line of a it is s·sin γ
/// beyond it, the touching point f at least x before it: |f − q|² ≥ (x + s sin γ)², which is at least 2 r s·slope for
/// every s if x ≥ r·slope / (2 sin γ).
double insetForVertexNeighbour(double slope, double from, double to) {
  if (from < 0.0 || to >= std::numbers::pi) return kUnknown;
  const double sine = std::min(math::sin(from), math::sin(to));
  return sine > 0.0 ? 0.5 * slope / sine : kUnknown;
}

}  // namespace

void WalkableMesh::checkVertexNeighbours(std::uint32_t triangle) {
  const auto v = mesh().vertices();
  const Triangle& t = mesh().triangles()[triangle];
  const Vec3 across = cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]]);
  const double twice_area = length(across);
  const Vec3 normal = unit(across);
  std::array<std::array<double, 3>, 2> inset{}, strip{}, disc{};  // times the radius, in mm
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const Vec3 at = v[t[corner]];
    const std::size_t next = (corner + 1) % 3, previous = (corner + 2) % 3;  // edge `corner` goes to next
    const Vec3 x = unit(v[t[next]] - at), y = cross(normal, x);
    const auto angleOf = [&](const Vec3& way) {
      const double a = math::atan2(dot(way, y), dot(way, x));
      return a < 0.0 ? a + 2.0 * std::numbers::pi : a;
    };
    const double opening = angleOf(v[t[previous]] - at);
    for (const std::uint32_t other : fans_[t[corner]]) {
      if (other == triangle) continue;
      const Triangle& o = mesh().triangles()[other];
      const auto has = [&o](std::uint32_t w) { return o[0] == w || o[1] == w || o[2] == w; };
      const std::size_t own = o[0] == t[corner] ? 0 : o[1] == t[corner] ? 1 : 2;
      const Vec3 p = v[o[(own + 1) % 3]] - at, q = v[o[(own + 2) % 3]] - at;
      const bool at_next = has(t[next]), at_previous = has(t[previous]);
      const Vec3 its = cross(p, q);
      const double lean = dot(its, normal);
      for (std::size_t side = 0; side < 2; ++side) {
        const double sign = side == 1 ? 1.0 : -1.0;
        if (at_next || at_previous) {
          if (at_next && at_previous) {  // on the same three vertices
            inset[side][corner] = kUnknown;
          } else if (at_next) {  // the edge to the previous corner is that corner's
            std::uint32_t third = 0;
            for (const std::uint32_t w : o) third = w != t[corner] && w != t[next] ? w : third;
            const Vec3 way = v[third] - at;
            const double high = sign * dot(way, normal), out = -dot(way, y);
            if (high > 0.0) {  // tan of half the angle
              const double half = out > 0.0 ? high / (std::sqrt(high * high + out * out) + out) : kUnknown;
              inset[side][corner] = std::max(inset[side][corner], half);
            } else if (!(out > 0.0)) {
              inset[side][corner] = std::max(inset[side][corner], high < 0.0 ? 0.0 : kUnknown);
            }
          }
          continue;
        }
        const double p_high = sign * dot(p, normal), q_high = sign * dot(q, normal);
        if (p_high <= 0.0 && q_high <= 0.0) continue;
        double by_next = kUnknown, by_previous = kUnknown, by_corner = kUnknown;
        const double from = angleOf(p), to = angleOf(q);  // from the edge to next; T is between 0 and its opening
        if (lean > 0.0 && from >= opening && to > from) {
          const Vec3 p_flat = p - dot(p, normal) * normal, q_flat = q - dot(q, normal) * normal;
          double slope = std::max(p_high / length(p_flat), q_high / length(q_flat));
          const Vec3 steepest = (-sign) * (its - lean * normal);
          if (dot(cross(p_flat, steepest), normal) > 0.0 && dot(cross(steepest, q_flat), normal) > 0.0) {
            slope = std::max(slope, length(steepest) / lean);
          }
          by_previous = insetForVertexNeighbour(slope, from - opening, to - opening);
          by_next = insetForVertexNeighbour(slope, 2.0 * std::numbers::pi - to, 2.0 * std::numbers::pi - from);
          // |f − q|² ≥ x² + s² − 2 x s cos γ, with x from the vertex
          const double apart = std::min(from - opening, 2.0 * std::numbers::pi - to);
          const double cosine = apart < 0.5 * std::numbers::pi ? math::cos(apart) : 0.0;
          if (cosine < 1.0) by_corner = slope / (1.0 - cosine);
        }
        disc[side][corner] = std::max(disc[side][corner], by_corner);
        // One of the two edges is enough; where its bound does not hold, the triangles at the corner are checked.
        const bool to_next = std::max(by_next, strip[side][corner]) <= std::max(by_previous, strip[side][previous]);
        double& known = strip[side][to_next ? corner : previous];
        known = std::max(known, to_next ? by_next : by_previous);
      }
    }
  }
  constexpr double kRoundedUp = 1.0 + 1e-6;
  for (std::size_t side = 0; side < 2; ++side) {
    Side& to = sides_[side][triangle];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto height_mm = [&](std::size_t edge) { return twice_area / length(v[t[(edge + 1) % 3]] - v[t[edge]]); };
      const auto atLeast = [this](double per_mm) {
        const double per_edge = per_mm * mesh().report().mean_edge_mm * kRoundedUp;
        return static_cast<Side::Quantised>(std::lower_bound(kLevels.begin(), kLevels.end(), per_edge) -
                                            kLevels.begin());
      };
      to.edge[i] = atLeast(inset[side][i] / height_mm(i));
      to.strip[i] = atLeast(strip[side][i] / height_mm(i));
      to.disc[i] = atLeast(disc[side][i] / height_mm((i + 1) % 3));
    }
  }
}

std::size_t WalkableMesh::bytes() const { return fans_.bytes() + (sizeof(Link) + 2 * sizeof(Side)) * links_.size(); }

Nearest NearestPoint::ofTriangle(const Vec3& probe_mm, std::uint32_t triangle) const {
  const auto v = on_->mesh().vertices();
  const Triangle& t = on_->link(triangle).corner;
  return nearestOf(probe_mm, v[t[0]], v[t[1]], v[t[2]], triangle);
}

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): of `vertex` only the first `count` are read
struct NearestPoint::CheckedVertices {
  std::array<std::uint32_t, 6> vertex;
  std::size_t count = 0;

  [[nodiscard]] bool at(std::uint32_t v) const {
    for (std::size_t i = 0; i < count; ++i) {
      if (vertex[i] == v) return true;
    }
    return false;
  }
  void add(std::uint32_t v) {
    if (count < vertex.size()) vertex[count++] = v;
  }
};

bool NearestPoint::improve(const Vec3& probe_mm, std::uint32_t vertex, CheckedVertices& checked, Nearest& best) const {
  // Its triangles were no nearer than an earlier `best`, so none is nearer now.
  if (checked.at(vertex)) return false;
  checked.add(vertex);
  bool found = false;
  const auto fan = on_->fans()[vertex];
  if (fan.size() > kLargestFan) return false;
  for (const std::uint32_t t : fan) {
    if (t == best.triangle) continue;
    const Nearest other = ofTriangle(probe_mm, t);
    if (!nearer(other, best)) continue;
    best = other;
    found = true;
  }
  return found;
}

bool NearestPoint::improveAround(const Vec3& probe_mm, std::uint32_t triangle, const std::array<double, 3>& share,
                                 const WalkableMesh::Side& side, double radius, std::size_t on_edge,
                                 CheckedVertices& checked, Nearest& best) const {
  constexpr std::array<std::size_t, 3> kNext = {1, 2, 0};
  const auto away = [radius](WalkableMesh::Side::Quantised quantised) {
    return radius * WalkableMesh::dequantised(quantised);
  };
  std::array<bool, 3> beyond{}, strip{};
  for (std::size_t e = 0; e < 3; ++e) {
    const double over = share[kNext[kNext[e]]];
    beyond[e] = e != on_edge && !(over > away(side.edge[e]) && over > kAtEdge);
    strip[e] = over < away(side.strip[e]);
  }
  const WalkableMesh::Link& link = on_->link(triangle);
  bool better = false;
  for (std::size_t e = 0; e < 3; ++e) {  // corner e is between the edges e and the one before
    if ((strip[e] || strip[kNext[kNext[e]]]) && 1.0 - share[e] < away(side.disc[e])) {
      better = improve(probe_mm, link.corner[e], checked, best) || better;
    }
    if (!beyond[e]) continue;
    const std::uint32_t across = link.across[e];
    if (across == kNoTriangle) {
      better = improve(probe_mm, link.corner[e], checked, best) || better;
      better = improve(probe_mm, link.corner[kNext[e]], checked, best) || better;
      continue;
    }
    const Nearest other = ofTriangle(probe_mm, across);
    if (!nearer(other, best)) continue;
    best = other;
    better = true;
  }
  return better;
}

bool NearestPoint::improveUntilCertain(const Vec3& probe_mm, Nearest& best) const {
  const auto v = on_->mesh().vertices();
  const double per_edge = 1.0 / on_->mesh().report().mean_edge_mm;
  CheckedVertices checked;
  for (int moves = 0; moves < kMostMoves; ++moves) {
    const std::uint32_t triangle = best.triangle;
    const auto& [t, neighbours] = on_->link(triangle);
    const auto feature = static_cast<std::size_t>(best.feature);
    const double distance = std::sqrt(best.squared_mm2) * per_edge;  // in mean edges
    const std::array<double, 3> share = {1.0 - best.at_1 - best.at_2, best.at_1, best.at_2};
    const Vec3 away = probe_mm - best.point_mm, one = cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]]);
    const bool outside = dot(one, away) > 0.0;
    if (best.feature == Feature::inside) {
      const WalkableMesh::Side& side = on_->side(triangle, outside);
      if (improveAround(probe_mm, triangle, share, side, distance, 3, checked, best)) continue;
      return distance < WalkableMesh::dequantised(side.empty);
    }
    if (feature < 3) {
      if (improve(probe_mm, t[feature], checked, best)) continue;
      return false;
    }
    const std::size_t edge = feature - 3;
    const std::uint32_t across = neighbours[edge];
    if (across == kNoTriangle) return false;
    const Nearest other = ofTriangle(probe_mm, across);
    if (nearer(other, best)) {
      best = other;
      continue;
    }
    const auto& [o, its_neighbours] = on_->link(across);
    const Vec3 two = cross(v[o[1]] - v[o[0]], v[o[2]] - v[o[0]]);
    // The way must lie between both normals; the cosine of half their angle.
    const double cosine = dot(one, two) / std::sqrt(squared(one) * squared(two));
    if (!(cosine > 0.0) || (dot(two, away) > 0.0) != outside) return false;
    const double radius = distance / std::sqrt(0.5 + 0.5 * cosine);
    const WalkableMesh::Side &side = on_->side(triangle, outside), &beyond = on_->side(across, outside);
    std::size_t its_edge = 0;
    std::array<double, 3> its_share{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (o[i] == t[k]) its_share[i] = share[k];
      }
      if (its_neighbours[i] == triangle) its_edge = i;
    }
    if (improveAround(probe_mm, triangle, share, side, radius, edge, checked, best)) continue;
    if (improveAround(probe_mm, across, its_share, beyond, radius, its_edge, checked, best)) continue;
    return radius < std::min(WalkableMesh::dequantised(side.empty), WalkableMesh::dequantised(beyond.empty));
  }
  return false;
}

std::uint32_t NearestPoint::walk(const Vec3& probe_mm) const {
  const auto v = on_->mesh().vertices();
  std::uint32_t at = last_, before = kNoTriangle;
  for (int moves = 0; moves < kMostMoves; ++moves) {
    // On a large mesh most of a step is waiting for memory: fetch early what improveUntilCertain will read.
    __builtin_prefetch(&on_->side(at, false));
    const auto& [t, across] = on_->link(at);
    const Vec3 ab = v[t[1]] - v[t[0]], ac = v[t[2]] - v[t[0]], ap = probe_mm - v[t[0]];
    const Vec3 normal = cross(ab, ac);
    const double at_1 = dot(cross(ap, ac), normal), at_2 = dot(cross(ab, ap), normal);
    const double at_0 = squared(normal) - at_1 - at_2;
    const double least = std::min({at_0, at_1, at_2});
    if (least >= 0.0) break;
    const std::uint32_t next = across[least == at_0 ? 1 : least == at_1 ? 2 : 0];
    if (next == kNoTriangle || next == before) break;
    before = at;
    at = next;
  }
  return at;
}

Nearest NearestPoint::find(const Vec3& probe_mm) {
  Nearest best;
  if (last_ == kNoTriangle || !probe_mm.finite()) {
    best = on_->tree().nearest(probe_mm);
  } else {
    best = ofTriangle(probe_mm, walk(probe_mm));
    if (!improveUntilCertain(probe_mm, best)) best = on_->tree().nearest(probe_mm, best.triangle);
  }
  last_ = best.triangle;
  return best;
}

}  // namespace fyd::scene
