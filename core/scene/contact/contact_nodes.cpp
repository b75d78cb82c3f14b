#include "core/scene/contact/contact_nodes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/scene/mesh/vector.h"

namespace fyd::scene {
namespace {

constexpr double kDeepest = 2.0;          // radii
constexpr double kRegularisation = 0.05;  // of W, added to the sum of weights

}  // namespace

ContactNodes::ContactNodes(const Mesh& mesh, double radius_mm)
    : radius_mm_(radius_mm),
      regularisation_(kRegularisation * static_cast<double>(mesh.vertices().size()) / mesh.report().area_mm2 *
                      std::numbers::pi / 3.0 * radius_mm * radius_mm),
      lowest_mm_(mesh.report().lowest_mm) {
  const Vec3 extent = mesh.report().highest_mm - lowest_mm_;
  const double longest_mm = std::max({extent.x, extent.y, extent.z});
  const double most = 2.0 * static_cast<double>(mesh.vertices().size()) + 64.0;
  // Cells grow until there are no more than `most`.
  for (cell_mm_ = std::max(radius_mm, longest_mm / 1024.0);; cell_mm_ *= 1.25) {
    cells_ = {static_cast<std::int64_t>(extent.x / cell_mm_) + 1, static_cast<std::int64_t>(extent.y / cell_mm_) + 1,
              static_cast<std::int64_t>(extent.z / cell_mm_) + 1};
    if (static_cast<double>(cells_[0]) * static_cast<double>(cells_[1]) * static_cast<double>(cells_[2]) <= most) break;
  }
  const auto place = [this](const Vec3& p) {
    const auto c = cellOf(p);
    return static_cast<std::size_t>((c[2] * cells_[1] + c[1]) * cells_[0] + c[0]);
  };
  begin_.assign(static_cast<std::size_t>(cells_[0] * cells_[1] * cells_[2]) + 1, 0);
  for (const Vec3& p : mesh.vertices()) ++begin_[place(p) + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  nodes_.resize(mesh.vertices().size());
  for (std::uint32_t v = 0; v < nodes_.size(); ++v) {
    const Vec3& p = mesh.vertices()[v];
    nodes_[next[place(p)]++] = {p, mesh.vertexNormal(v)};
  }
}

std::array<std::int64_t, 3> ContactNodes::cellOf(const Vec3& point_mm) const {
  const auto of = [this](double from_mm, std::int64_t count) {
    const double cell = std::floor(from_mm / cell_mm_);
    return static_cast<std::int64_t>(std::clamp(cell, 0.0, static_cast<double>(count - 1)));
  };
  const Vec3 from = point_mm - lowest_mm_;
  return {of(from.x, cells_[0]), of(from.y, cells_[1]), of(from.z, cells_[2])};
}

Push ContactNodes::push(const Vec3& probe_mm, const Nearest& nearest) const {
  const double squared_mm2 = radius_mm_ * radius_mm_, deepest_mm2 = kDeepest * kDeepest * squared_mm2;
  if (!(nearest.squared_mm2 < deepest_mm2)) return {};
  // Nodes farther away than this have no weight.
  const double reach_mm = std::sqrt(squared_mm2 + deepest_mm2);
  const Vec3 all = {reach_mm, reach_mm, reach_mm};
  const auto low = cellOf(probe_mm - all), high = cellOf(probe_mm + all);
  double weights = 0.0, depths = 0.0;
  Vec3 weights_gradient, depths_gradient;  // with respect to the probe's position
  for (std::int64_t z = low[2]; z <= high[2]; ++z) {
    for (std::int64_t y = low[1]; y <= high[1]; ++y) {
      const std::int64_t row = (z * cells_[1] + y) * cells_[0];
      const std::uint32_t to = begin_[static_cast<std::size_t>(row + high[0]) + 1];
      for (std::uint32_t i = begin_[static_cast<std::size_t>(row + low[0])]; i < to; ++i) {
        const Node& node = nodes_[i];
        const Vec3 to_node = node.point_mm - probe_mm;
        const double h = dot(to_node, node.normal);
        const Vec3 tangential = to_node - h * node.normal;
        const double a = 1.0 - squared(tangential) / squared_mm2, b = 1.0 - h * h / deepest_mm2;
        if (!(a > 0.0) || !(b > 0.0)) continue;
        const double weight = a * a * b * b;
        const Vec3 weight_gradient =
            (4.0 * a * b * b / squared_mm2) * tangential + (4.0 * a * a * b * h / deepest_mm2) * node.normal;
        weights += weight;
        weights_gradient = weights_gradient + weight_gradient;
        if (!(h > 0.0)) continue;
        depths += weight * h;
        depths_gradient = depths_gradient + h * weight_gradient - weight * node.normal;
      }
    }
  }
  const double total = weights + regularisation_;
  const double depth_mm = (1.0 + kRegularisation) * depths / total;
  if (!(depth_mm > 0.0)) return {};
  const Vec3 depth_gradient = (1.0 / total) * ((1.0 + kRegularisation) * depths_gradient - depth_mm * weights_gradient);
  const Vec3 force_over_stiffness_mm = -depth_mm * depth_gradient;
  return {force_over_stiffness_mm, probe_mm + force_over_stiffness_mm, unit(force_over_stiffness_mm), depth_mm};
}

std::size_t ContactNodes::bytes() const {
  return begin_.size() * sizeof(begin_[0]) + nodes_.size() * sizeof(nodes_[0]);
}

}  // namespace fyd::scene
