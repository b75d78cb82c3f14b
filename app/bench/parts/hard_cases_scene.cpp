// Meshes, contacts and bodies.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/bench/parts/hard_case.h"
#include "app/bench/parts/scene_bumpy_plane.h"
#include "core/scene/gesture/flight.h"
#include "core/scene/gesture/racket.h"
#include "core/scene/gesture/swords.h"
#include "core/scene/mesh/triangle_distance.h"
#include "core/scene/mesh/triangle_tree.h"
#include "core/scene/mesh/vector.h"
#include "core/scene/soft/soft_body.h"

namespace fyd::bench {
namespace {

using namespace scene;

HardCase bladesNearlyParallel() {
  // Along `forth` they cross 1 mm apart at 300 mm: aside = 2e-6·x − 6e-4. The three are perpendicular and of length 1.
  const Vec3 forth{0.6, 0.64, 0.48}, aside{0.8, -0.48, -0.36}, up{0.0, 0.6, -0.8};
  const Blade a{{}, 1000.0 * forth}, b{up - 6e-4 * aside, 1000.0 * forth + up + 14e-4 * aside};
  const Vec3 u = a.tip_mm - a.grip_mm, v = b.tip_mm - b.grip_mm, w = a.grip_mm - b.grip_mm;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const double naive = (uv * vw - vv * uw) / (uu * vv - uv * uv);
  return {.name = "where two blades that are parallel to 2e-6 rad are nearest",
          .naive = "the formula of the textbook: its denominator cancels",
          .ours = "the square of the cross product (`scene::nearestOf`)",
          .truth = "similar triangles: 300 mm",
          .unit = "mm",
          .naive_error = std::isfinite(naive) ? std::abs(1000.0 * naive - 300.0) : kNotFinite,
          .our_error = std::abs(1000.0 * nearestOf(a, b).at_a - 300.0),
          .at_most = 2e-5};
}

HardCase bladesThatPassInOneStep() {
  // One blade comes from 100 mm above another to 100 mm below it within a step of 10 ms.
  constexpr int kPasses = 100;
  const SwordParameters parameters{.radius_mm = 5.0};
  HardCase out{.name = "a blade that passes through another at 20 m/s: passes that are missed",
               .naive = "the distance at each step",
               .ours = "the times at which four moving points lie in a plane (`scene::stepSwords`)",
               .truth = "every pass crosses",
               .unit = "of 100",
               .at_most = 0.0};
  for (int i = 0; i < kPasses; ++i) {
    const double x = -200.0 + 4.0 * i;
    const Blade still{{x, -450.0, 0.0}, {x, 450.0, 0.0}};
    SwordState state;
    bool naive = false, ours = false;
    for (const double height : {100.0, -100.0}) {
      const Blade moving{{-450.0, 0.1 * i, height}, {450.0, -0.2 * i, height}};
      const Vec3 apart = nearestOf(moving, still).apart_mm;
      naive = naive || apart.norm() <= 2.0 * parameters.radius_mm;
      ours = ours || stepSwords(parameters, state, moving, still, 0.01).touching;
    }
    out.naive_error += naive ? 0.0 : 1.0;
    out.our_error += ours ? 0.0 : 1.0;
  }
  return out;
}

HardCase timeUntilATouch() {
  constexpr double kGap_mm = 1e-10, kRate_mm_s = -5000.0, kMost_mm_s2 = 9806.65;
  const auto gap = [&](double t) {
    return Gap{kGap_mm + kRate_mm_s * t - 0.5 * kMost_mm_s2 * t * t, kRate_mm_s - kMost_mm_s2 * t};
  };
  const double root = std::sqrt(kRate_mm_s * kRate_mm_s + 2.0 * kMost_mm_s2 * kGap_mm);
  const double naive = (kRate_mm_s + root) / kMost_mm_s2;
  const long double rate = kRate_mm_s, most = kMost_mm_s2;
  const auto truth = static_cast<double>(2.0L * kGap_mm / (std::sqrt(rate * rate + 2.0L * most * kGap_mm) - rate));
  const auto ours = firstMeeting(gap, 1.0, kMost_mm_s2, 1e-20);
  return {.name = "time until a ball at 5 m/s meets a plane 1e-10 mm away",
          .naive = "(−b + √(b² − 4ac))/2a",
          .ours = "the root's other form (`scene::firstMeeting`)",
          .truth = "long double, without cancellation",
          .unit = "relative",
          .naive_error = std::abs(naive / truth - 1.0),
          .our_error = ours ? std::abs(*ours / truth - 1.0) : kNotFinite,
          .at_most = 1e-9};
}

HardCase racketThatHardlyTurns() {
  constexpr double kAngle = 1e-9;
  const RacketPose from;
  RacketPose to;
  to.normal = {std::sin(kAngle), 0.0, std::cos(kAngle)};
  to.along = {std::cos(kAngle), 0.0, -std::sin(kAngle)};
  const RacketMotion motion(from, to, 0.01, 1e6);
  const double naive = std::sin(0.5 * std::acos(std::min(1.0, dot(from.normal, to.normal))));
  const double truth = std::sin(0.5 * kAngle);
  return {.name = "a racket that turns by 1e-9 rad: where it is half-way",
          .naive = "the angle by arc cosine",
          .ours = "by atan2 of sine and cosine (`scene::RacketMotion`)",
          .truth = "closed form",
          .unit = "relative",
          .naive_error = std::abs(naive / truth - 1.0),
          .our_error = std::abs(motion.at(0.005).normal.x / truth - 1.0),
          .at_most = 1e-6};
}

HardCase triangleWithoutArea() {
  // A square of two triangles and a third one on its border that has no area; the probe is 3 mm over it, 4 mm outside.
  TriangleSoup soup;
  soup.vertices = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {5, 0, 0}};
  soup.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}};
  const Vec3 probe{5.0, -4.0, 3.0};
  const auto& v = soup.vertices;
  double naive = 0.0;
  for (const Triangle& t : soup.triangles) {
    const Vec3 normal = cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]]);
    const Vec3 unit_normal = (1.0 / std::sqrt(dot(normal, normal))) * normal;
    naive += dot(unit_normal, probe - v[t[0]]);  // the sum of what each plane pushes
  }
  const auto mesh = Mesh::build(soup);
  double ours = kNotFinite;
  if (mesh) ours = std::abs(std::sqrt(TriangleTree(*mesh).nearest(probe).squared_mm2) - 5.0);
  return {.name = "distance to a mesh that has a triangle without an area",
          .naive = "the plane of each triangle, its normal divided by its length",
          .ours = "is left out, and reported (`scene::Mesh`)",
          .truth = "3-4-5: 5 mm",
          .unit = "mm",
          .naive_error = std::isfinite(naive) ? std::abs(naive - 5.0) : kNotFinite,
          .our_error = ours,
          .at_most = 1e-12};
}

HardCase meshFarFromTheOrigin() {
  // As surveyors' coordinates are: floats are 8 mm apart there, and triangles lie across the middle between two of them.
  // Both compute distances to triangles in double.
  constexpr double kFar_mm = 1e8 + 0.5, kAbove_mm = 0.25, kReach_mm = 40.0;
  constexpr int kProbes = 200;
  TriangleSoup flat = bumpyPlane(100);
  for (Vec3& each : flat.vertices) each = {each.x + kFar_mm, each.y + kFar_mm, kFar_mm};
  HardCase out{.name = "distance to a mesh of 100 mm that lies 100 km from the origin",
               .naive = "spheres in float around its triangles; one that is farther than the nearest yet is skipped",
               .ours = "discs around the mesh's middle, grown by what floats lose (`scene::TriangleTree`)",
               .truth = "a plane: 0.25 mm",
               .unit = "mm",
               .at_most = 1e-7};
  const auto mesh = Mesh::build(flat);
  if (!mesh) {
    out.our_error = kNotFinite;
    return out;
  }
  struct Sphere {
    std::array<float, 3> middle{};
    float radius = 0.0F;
  };
  const auto floats = [](const Vec3& v) {
    return std::array<float, 3>{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  };
  std::vector<Sphere> spheres;
  spheres.reserve(mesh->triangles().size());
  for (const Triangle& t : mesh->triangles()) {
    const auto v = mesh->vertices();
    const Vec3 middle = (1.0 / 3.0) * (v[t[0]] + v[t[1]] + v[t[2]]);
    double radius = 0.0;
    for (const std::uint32_t corner : t) radius = std::max(radius, (v[corner] - middle).norm());
    spheres.push_back({floats(middle), static_cast<float>(radius)});
  }
  const TriangleTree tree(*mesh);
  for (int i = 0; i < kProbes; ++i) {
    const double along_mm = kReach_mm * (2.0 * i / kProbes - 1.0);
    const Vec3 probe{kFar_mm + along_mm, kFar_mm + 0.731 * along_mm, kFar_mm + kAbove_mm};
    const auto from = floats(probe);
    double naive_mm = kNotFinite;
    for (std::uint32_t t = 0; t < spheres.size(); ++t) {
      const auto& middle = spheres[t].middle;
      const float away = std::hypot(from[0] - middle[0], from[1] - middle[1], from[2] - middle[2]) - spheres[t].radius;
      if (away > static_cast<float>(naive_mm)) continue;
      naive_mm = std::min(naive_mm, std::sqrt(nearestOnTriangle(*mesh, probe, t).squared_mm2));
    }
    const double ours_mm = std::sqrt(tree.nearest(probe).squared_mm2);
    out.naive_error = std::max(out.naive_error, std::abs(naive_mm - kAbove_mm));
    out.our_error = std::max(out.our_error, std::abs(ours_mm - kAbove_mm));
  }
  return out;
}

HardCase stiffAndLight() {
  // A body of 1 mg at 0.5 N/mm: ω·Δt is 22.
  constexpr double kDepth_mm = 1.5, kRigidity_N_per_mm = 0.5, kMass_kg = 1e-6, kStep_s = 1e-3;
  double x = 0.0, v = 0.0, naive = 0.0;
  for (int i = 0; i < 1000; ++i) {  // pressed by a weight of as much force
    v += kStep_s * 1e3 * (kRigidity_N_per_mm * kDepth_mm - kRigidity_N_per_mm * x) / kMass_kg;
    x += kStep_s * v;
    naive = kRigidity_N_per_mm * x;
  }
  const double truth = kRigidity_N_per_mm * kDepth_mm;
  TriangleSoup flat = bumpyPlane(40);
  for (Vec3& each : flat.vertices) each.z = 0.0;
  const auto mesh = Mesh::build(flat);
  double ours = kNotFinite;
  if (mesh) {
    const TriangleTree tree(*mesh);
    auto body = SoftBody::build(tree, {.mass_kg = kMass_kg, .rigidity_N_per_mm = kRigidity_N_per_mm, .finger_mm = 8.0});
    if (body) {
      for (int i = 0; i < 1000; ++i) body->step(kStep_s, {0.3, 0.2, -kDepth_mm});
      ours = std::abs(body->contact().force_N.norm() / truth - 1.0);
    }
  }
  return {.name = "a stiff and light body pressed 1.5 mm deep, steps of 1 ms: force at rest",
          .naive = "symplectic Euler",
          .ours = "implicit Euler (`scene::SoftBody`)",
          .truth = "Hooke: rigidity · depth",
          .unit = "relative",
          .naive_error = std::isfinite(naive) ? std::abs(naive / truth - 1.0) : kNotFinite,
          .our_error = ours,
          .at_most = 0.03};
}

HardCase lengthOfAHugeVector() {
  const Vec3 huge{3e200, 4e200, 0.0};
  const double naive = std::sqrt(huge.x * huge.x + huge.y * huge.y + huge.z * huge.z);
  return {.name = "length of (3, 4, 0)·10²⁰⁰",
          .naive = "the root of the sum of squares: it overflows",
          .ours = "`Vec3::norm`",
          .truth = "3-4-5: 5·10²⁰⁰",
          .unit = "relative",
          .naive_error = std::isfinite(naive) ? std::abs(naive / 5e200 - 1.0) : kNotFinite,
          .our_error = std::abs(huge.norm() / 5e200 - 1.0),
          .at_most = 1e-15};
}

}  // namespace

std::vector<HardCase> hardCasesOfScenes() {
  return {bladesNearlyParallel(), bladesThatPassInOneStep(), timeUntilATouch(), racketThatHardlyTurns(),
          triangleWithoutArea(),  meshFarFromTheOrigin(),    stiffAndLight(),   lengthOfAHugeVector()};
}

}  // namespace fyd::bench
