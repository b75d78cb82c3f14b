#include "core/scene/soft/soft_choice.h"

#include <algorithm>

#include "core/scene/mesh/vector.h"

namespace fyd::scene {
namespace {

constexpr std::array<std::size_t, 5> kParts = {16, 8, 4, 2, 1};  // of what a press wakes
constexpr std::size_t kLeast = 3;
constexpr std::size_t kPressedPlaces = 3;
constexpr int kDown = 30, kHeld = 30;  // steps of 1 ms
constexpr double kPress_N = 1.0;
constexpr double kDeepestPress = 0.02;  // of the mesh's diagonal

struct Pressed {
  std::vector<double> force_N;
  std::size_t awake = 0;
};

Result<Pressed> press(const TriangleTree& tree, const SoftMaterial& material, const SoftResolution& resolution,
                      double depth_mm) {
  auto body = SoftBody::build(tree, material, resolution);
  if (!body) return tl::unexpected(body.error());
  const Mesh& mesh = tree.mesh();
  Pressed out;
  for (std::size_t place = 0; place < kPressedPlaces; ++place) {
    const auto t = static_cast<std::uint32_t>((2 * place + 1) * mesh.triangles().size() / (2 * kPressedPlaces));
    const auto v = mesh.vertices();
    const Triangle& c = mesh.triangles()[t];
    const Vec3 at = (1.0 / 3.0) * (v[c[0]] + v[c[1]] + v[c[2]]), normal = mesh.triangleNormal(t);
    body->reset();
    for (int i = 0; i < kDown + kHeld; ++i) {
      const double down = std::min(1.0, static_cast<double>(i) / kDown);
      const SoftContact& touch = body->step(1e-3, at + (0.2 - 1.2 * down) * depth_mm * normal);
      out.force_N.push_back(length(touch.force_N));
    }
    out.awake = std::max(out.awake, body->awake().size());
  }
  return out;
}

}  // namespace

Result<SoftChoiceReport> chooseSoft(const TriangleTree& tree, const SoftMaterial& material, double accuracy) {
  const MeshReport& mesh = tree.mesh().report();
  SoftChoiceReport out;
  out.depth_mm =
      std::min(kPress_N / material.rigidity_N_per_mm, kDeepestPress * length(mesh.highest_mm - mesh.lowest_mm));
  const auto whole = press(tree, material, {}, out.depth_mm);
  if (!whole) return tl::unexpected(whole.error());
  double largest_N = 0.0;
  for (const double f : whole->force_N) largest_N = std::max(largest_N, f);
  for (std::size_t i = 0; i < kParts.size(); ++i) {
    SoftTrial& trial = out.trials[i];
    trial.most_points = std::max(kLeast, whole->awake / kParts[i]);
    const auto part = press(tree, material, {.most_points = trial.most_points}, out.depth_mm);
    if (!part) return tl::unexpected(part.error());
    double sum = 0.0;
    for (std::size_t k = 0; k < part->force_N.size(); ++k) sum += std::abs(part->force_N[k] - whole->force_N[k]);
    const double mean_N = sum / static_cast<double>(part->force_N.size());
    trial.mean_error = largest_N > 0.0 ? mean_N / largest_N : 0.0;
    if (out.met) continue;
    out.met = trial.mean_error <= accuracy;
    out.chosen.most_points = trial.most_points;
  }
  return out;
}

}  // namespace fyd::scene
