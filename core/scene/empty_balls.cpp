// The balls of nearest_point.h that touch a triangle and hold nothing of the triangles that share no vertex with it.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/scene/triangle_tree.h"
#include "core/scene/vector.h"

namespace fyd::scene {
namespace {

constexpr double kRounding = 1e-8;    // of the mesh's size: more than doubles lose; discs are grown for theirs
constexpr double kLess = 1.0 - 1e-3;  // a ball gives way to what it holds by so much, so that few turns are needed
constexpr int kMostTurns = 12;

/// How large a ball that touches a triangle T may be at most so that it holds nothing of something that rises at most
/// so high over T's plane and is at least so far from T along it.
double ballBeside(double high, double away) {
  if (high <= 0.0) return std::numeric_limits<double>::infinity();
  const double up = std::min(high, away);
  if (up <= 0.0) return 0.0;
  return (up * up + away * away) / (2.0 * up);
}

struct Patch {
  Vec3 a, b, c;
};

}  // namespace

/// For one triangle: the smallest ball over what was looked at.
struct TriangleTree::Balls {
  const TriangleTree& tree;
  Triangle own;
  Patch patch;  // around the mesh's middle
  Vec3 normal, centre;
  double radius_mm;  // of the triangle's circle around its centre
  double slack_mm;
  std::array<double, 2> empty;

  /// Lower bounds for something within a circle; low, high: over the plane.
  void bound(double low, double high, double away, std::array<double, 2>& out) const {
    const double g = std::max(0.0, away - slack_mm);
    out = {ballBeside(slack_mm - low, g), ballBeside(high + slack_mm, g)};
  }
  [[nodiscard]] bool matters(const std::array<double, 2>& b) const { return b[0] < empty[0] || b[1] < empty[1]; }

  /// The ball of radius r that touches T from one side in f holds q exactly when G = |q − f|² − 2 r n·(q − f) < 0,
  /// which is convex over T × U: minimised in turn over q and f; its tangent plane bounds it from below.
  void ofTriangle(const Patch& other) {
    const auto over = [&](const Vec3& p) { return dot(normal, p - patch.a); };
    const double x = over(other.a), y = over(other.b), z = over(other.c);
    if (std::max({x, y, z}) > -slack_mm) ofSide(other, normal, empty[1]);
    if (std::min({x, y, z}) < slack_mm) ofSide(other, -1.0 * normal, empty[0]);
  }
  void ofSide(const Patch& other, const Vec3& n, double& r) {
    const auto least = [](const Patch& of, const Vec3& slope) {
      return std::min({dot(of.a, slope), dot(of.b, slope), dot(of.c, slope)});
    };
    Vec3 f = centre;
    for (int turn = 0; turn < kMostTurns && r > 0.0; ++turn) {
      const Vec3 q = nearestOf(f + r * n, other.a, other.b, other.c, 0).point_mm;
      f = nearestOf(q, patch.a, patch.b, patch.c, 0).point_mm;
      const Vec3 w = q - f;
      const double high = dot(n, w), far = squared(w), g = far - 2.0 * r * high;
      const Vec3 by_q = 2.0 * (w - r * n), by_f = -2.0 * w;  // n is across T: moving f does not change n·f
      const double lost = slack_mm * (std::sqrt(far) + std::abs(high));
      if (g + least(other, by_q) - dot(q, by_q) + least(patch, by_f) - dot(f, by_f) >= lost) return;
      if (g < lost) r = high > 0.0 ? std::min(r, kLess * std::max(0.0, far - lost) / (2.0 * high)) : 0.0;
    }
    r = 0.5 * r;  // not settled
  }

  [[nodiscard]] std::array<double, 2> ofDisc(const Node& node, std::size_t i) const {
    const Vec3 way = Vec3{node.middle[0][i], node.middle[1][i], node.middle[2][i]} - centre;
    const double up = dot(way, normal);
    const double lean = dot(normal, {node.normal[0][i], node.normal[1][i], node.normal[2][i]});
    const double reach = node.radius[i] * std::sqrt(std::max(0.0, 1.0 - lean * lean)) + node.height[i] * std::abs(lean);
    const double along = std::sqrt(std::max(0.0, squared(way) - up * up));
    std::array<double, 2> b;
    bound(up - reach, up + reach,
          along - radius_mm - std::sqrt(node.radius[i] * node.radius[i] + node.height[i] * node.height[i]), b);
    return b;
  }

  void ofNode(std::int32_t which) {
    const Node& node = tree.nodes_[static_cast<std::size_t>(which)];
    std::array<std::size_t, 4> order{};  // the smallest first: it may spare the others
    std::array<double, 4> least{};
    std::array<std::array<double, 2>, 4> b;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (node.child[i] == kNothing) continue;
      b[i] = ofDisc(node, i);
      if (!matters(b[i])) continue;
      least[i] = std::min(b[i][0], b[i][1]);
      std::size_t at = count++;
      for (; at > 0 && least[order[at - 1]] > least[i]; --at) order[at] = order[at - 1];
      order[at] = i;
    }
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = order[k];
      if (!matters(b[i])) continue;
      const std::int32_t child = node.child[i];
      if (child >= 0) {
        ofNode(child);
        continue;
      }
      const Triangle& t = tree.mesh_->triangles()[static_cast<std::size_t>(~child)];
      const bool apart = std::none_of(t.begin(), t.end(),
                                      [this](std::uint32_t v) { return v == own[0] || v == own[1] || v == own[2]; });
      const auto v = tree.mesh_->vertices();
      if (apart) ofTriangle({v[t[0]] - tree.middle_mm_, v[t[1]] - tree.middle_mm_, v[t[2]] - tree.middle_mm_});
    }
  }
};

std::array<double, 2> TriangleTree::emptyBalls_mm(std::uint32_t triangle, double largest_mm) const {
  const Triangle& t = mesh_->triangles()[triangle];
  const auto v = mesh_->vertices();
  Balls balls{*this,
              t,
              {v[t[0]] - middle_mm_, v[t[1]] - middle_mm_, v[t[2]] - middle_mm_},
              mesh_->triangleNormal(triangle),
              {},
              0.0,
              kRounding * size_mm_,
              {largest_mm, largest_mm}};
  const Patch& p = balls.patch;
  balls.centre = (1.0 / 3.0) * (p.a + p.b + p.c);
  balls.radius_mm =
      std::sqrt(std::max({squared(p.a - balls.centre), squared(p.b - balls.centre), squared(p.c - balls.centre)}));
  balls.ofNode(0);
  return balls.empty;
}

}  // namespace fyd::scene
