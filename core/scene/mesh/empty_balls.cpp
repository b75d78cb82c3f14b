// The balls of nearest_point.h that touch a triangle and hold nothing of the triangles that share no vertex with it.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/scene/mesh/four_floats.h"
#include "core/scene/mesh/triangle_tree.h"
#include "core/scene/mesh/vector.h"

namespace fyd::scene {
namespace {

constexpr double kBallRounding = 1e-8;       // of the mesh's size: more than doubles lose; discs are grown for theirs
constexpr double kRoundingOfFloats = 1e-6;   // likewise
constexpr float kRoundingOfSquares = 1e-6F;  // of a square
constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr double kShrink = 1.0 - 1e-3;  // a ball shrinks by this below the size that touches, so that few turns suffice
constexpr int kMostBallTurns = 48;
constexpr int kTurnsToConverge = 12;  // from then on the ball is halved in each turn: of a smaller one more is certain

/// The largest radius of a ball that touches a triangle T and holds nothing of a body that rises at most `high` over
/// T's plane and is at least `away` from T, measured along the plane. Infinite if it does not rise over the plane.
double largestBallBeside(double high, double away) {
  if (high <= 0.0) return std::numeric_limits<double>::infinity();
  const double up = std::min(high, away);
  if (up <= 0.0) return 0.0;
  return (up * up + away * away) / (2.0 * up);
}

struct Corners {
  Vec3 a, b, c;
};

}  // namespace

/// For one triangle T: on each side the largest ball that touches T and holds nothing of what was checked so far.
struct TriangleTree::EmptyBalls {
  const TriangleTree& tree;
  Triangle own{};
  Corners corners;  // relative to the mesh's middle
  Vec3 normal;
  double slack_mm = 0.0;
  std::array<double, 2> empty{};  // radii, mm: inside, outside
  Vec3 centre{};
  struct EdgeBound {
    Vec3 out;         // in T's plane, at right angles to an edge, outwards, of unit length
    double at = 0.0;  // the farthest point of T in this direction
  };
  std::array<EdgeBound, 3> beyond{};
  std::array<float, 3> centre_f{}, normal_f{};  // centre and normal as floats
  float circle_mm = 0.0F;                       // of the triangle's circle around its centre
  float float_rounding_mm = 0.0F;

  /// The ball of radius r that touches T from one side in f holds q exactly when G = |q − f|² − 2 r n·(q − f) < 0,
  /// which is convex over T × U: minimised in turn over q and f; its tangent plane bounds it from below.
  void ofTriangle(const Corners& other) {
    const auto over = [&](const Vec3& p) { return dot(normal, p - corners.a); };
    const double x = over(other.a), y = over(other.b), z = over(other.c);
    double away = 0.0;  // what is beyond an edge is at least as far from T
    for (const EdgeBound& edge : beyond) {
      away =
          std::max(away, std::min({dot(edge.out, other.a), dot(edge.out, other.b), dot(edge.out, other.c)}) - edge.at);
    }
    away = std::max(0.0, away - slack_mm);
    if (largestBallBeside(std::max({x, y, z}) + slack_mm, away) < empty[1]) ofSide(other, normal, empty[1]);
    if (largestBallBeside(slack_mm - std::min({x, y, z}), away) < empty[0]) ofSide(other, -1.0 * normal, empty[0]);
  }
  void ofSide(const Corners& other, const Vec3& n, double& r) {
    const auto least = [](const Corners& of, const Vec3& slope) {
      return std::min({dot(of.a, slope), dot(of.b, slope), dot(of.c, slope)});
    };
    Vec3 f = centre;
    for (int turn = 0; turn < kMostBallTurns && r > 0.0; ++turn) {
      const Vec3 q = nearestOf(f + r * n, other.a, other.b, other.c, 0).point_mm;
      f = nearestOf(q, corners.a, corners.b, corners.c, 0).point_mm;
      const Vec3 w = q - f;
      const double high = dot(n, w), far = squared(w), g = far - 2.0 * r * high;
      const Vec3 by_q = 2.0 * (w - r * n), by_f = -2.0 * w;  // n is normal to T: moving f does not change n·f
      const double rounding = slack_mm * (std::sqrt(far) + std::abs(high));
      if (g + least(other, by_q) - dot(q, by_q) + least(corners, by_f) - dot(f, by_f) >= rounding) return;
      if (g < rounding) r = high > 0.0 ? std::min(r, kShrink * std::max(0.0, far - rounding) / (2.0 * high)) : 0.0;
      if (turn >= kTurnsToConverge) r *= 0.5;
    }
    r = 0.0;  // of no ball it is certain
  }

  /// largestBallBeside of a node's four discs, for each side.
  [[nodiscard]] std::array<Floats, 2> ofDiscs(const Node& node) const {
    const Floats x = load(node.middle[0]) - centre_f[0], y = load(node.middle[1]) - centre_f[1],
                 z = load(node.middle[2]) - centre_f[2];
    const Floats up = x * normal_f[0] + y * normal_f[1] + z * normal_f[2];
    const Floats lean =
        load(node.normal[0]) * normal_f[0] + load(node.normal[1]) * normal_f[1] + load(node.normal[2]) * normal_f[2];
    const Floats all = x * x + y * y + z * z, radius = load(node.radius), height = load(node.height);
    const Floats tilt = root(larger(1.0F + kRoundingOfSquares - lean * lean, Floats{}));
    const Floats reach = radius * tilt + height * larger(lean, -lean) + float_rounding_mm;
    const Floats along = root(larger(all - up * up - kRoundingOfSquares * all, Floats{}));
    const Floats away = larger(along - radius - height - circle_mm, Floats{});
    const auto beside = [&away](Floats high) {
      const Floats rise = smaller(larger(high, Floats{}), away);
      const Floats ball = (rise * rise + away * away) / (2.0F * rise);
      return high <= 0.0F ? Floats{} + kInfinite : rise <= 0.0F ? Floats{} : (1.0F - kRoundingOfSquares) * ball;
    };
    return {beside(reach - up), beside(up + reach)};
  }

  void ofNode(std::int32_t which) {
    const Node& node = tree.nodes_[static_cast<std::size_t>(which)];
    const auto [inside, outside] = ofDiscs(node);
    const Floats either = smaller(inside, outside);
    const auto matters = [&, &inside = inside, &outside = outside](std::size_t i) {
      return inside[i] < empty[0] || outside[i] < empty[1];
    };
    std::array<std::size_t, 4> order{};  // the smallest first: it may spare the others
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (node.child[i] == kNothing || !matters(i)) continue;
      std::size_t at = count++;
      for (; at > 0 && either[order[at - 1]] > either[i]; --at) order[at] = order[at - 1];
      order[at] = i;
    }
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = order[k];
      if (!matters(i)) continue;
      const std::int32_t child = node.child[i];
      if (child >= 0) {
        ofNode(child);
        continue;
      }
      const Triangle& t = tree.mesh_->triangles()[static_cast<std::uint32_t>(~child)];
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
  EmptyBalls balls{.tree = *this,
                   .own = t,
                   .corners = {v[t[0]] - middle_mm_, v[t[1]] - middle_mm_, v[t[2]] - middle_mm_},
                   .normal = mesh_->triangleNormal(triangle),
                   .slack_mm = kBallRounding * size_mm_,
                   .empty = {largest_mm, largest_mm}};
  const Corners& p = balls.corners;
  balls.centre = (1.0 / 3.0) * (p.a + p.b + p.c);
  const double radius_mm =
      std::sqrt(std::max({squared(p.a - balls.centre), squared(p.b - balls.centre), squared(p.c - balls.centre)}));
  const auto floats = [](const Vec3& of) {
    return std::array<float, 3>{static_cast<float>(of.x), static_cast<float>(of.y), static_cast<float>(of.z)};
  };
  balls.centre_f = floats(balls.centre);
  balls.normal_f = floats(balls.normal);
  balls.float_rounding_mm = static_cast<float>(kRoundingOfFloats * size_mm_);
  balls.circle_mm = static_cast<float>(radius_mm + kRoundingOfFloats * size_mm_);
  const std::array<Vec3, 4> around = {p.a, p.b, p.c, p.a};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 out = unit(cross(around[i + 1] - around[i], balls.normal));
    balls.beyond[i] = {out, std::max({dot(out, p.a), dot(out, p.b), dot(out, p.c)})};
  }
  balls.ofNode(0);
  return balls.empty;
}

}  // namespace fyd::scene
