#include "core/sensing/light_surface.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace fyd::sensing {
namespace {

constexpr float kOff = 0.03F;          // of the light: cells farther from the surface are no bare cloth
constexpr float kBelowWeight = 0.03F;  // of a cell below the surface while the finger's place is unknown
constexpr double kRidge = 1e-4;        // keeps the high terms small where there are no cells

std::array<float, 9> terms(float u, float v) {
  const float r2 = u * u + v * v;
  return {1.0F, u, v, u * u, u * v, v * v, u * r2, v * r2, r2 * r2};
}

}  // namespace

void LightSurface::setRegion(int width, int height) {
  middle_x_ = 0.5F * static_cast<float>(width - 1);
  middle_y_ = 0.5F * static_cast<float>(height - 1);
  scale_ = 2.0F / static_cast<float>(std::max(width, 2));
  c_ = {};
}

bool LightSurface::solve(std::span<const Cell> cells, int count) {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kTerms, kTerms>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kTerms, 1>;
  std::array<std::array<double, kTerms>, kTerms> normal{};
  std::array<double, kTerms> right{};
  int used = 0;
  for (const Cell& cell : cells) {
    if (!(cell.weight > 0.0F)) continue;
    ++used;
    const auto t = terms(cell.u, cell.v);
    for (int i = 0; i < count; ++i) {
      const double wt = static_cast<double>(cell.weight * t[static_cast<std::size_t>(i)]);
      right[static_cast<std::size_t>(i)] += wt * static_cast<double>(cell.grey);
      for (int j = 0; j <= i; ++j) {
        normal[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] +=
            wt * static_cast<double>(t[static_cast<std::size_t>(j)]);
      }
    }
  }
  if (used < 2 * count) return false;
  Matrix a(count, count);
  Vector b(count);
  for (int i = 0; i < count; ++i) {
    b(i) = right[static_cast<std::size_t>(i)];
    for (int j = 0; j <= i; ++j) a(i, j) = normal[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    if (i >= 3) a(i, i) += kRidge * used;
  }
  const Eigen::LLT<Matrix, Eigen::Lower> factors(a);
  if (factors.info() != Eigen::Success) return false;
  const Vector solution = factors.solve(b);
  if (!solution.allFinite()) return false;
  c_ = {};
  for (int i = 0; i < count; ++i) c_[static_cast<std::size_t>(i)] = static_cast<float>(solution(i));
  return true;
}

bool LightSurface::fit(std::span<Cell> cells) {
  if (!solve(cells, kTerms)) return false;
  bool left_out = false;
  for (Cell& cell : cells) {
    if (!(cell.weight > 0.0F)) continue;
    const float light = at(cell.u, cell.v);
    if (std::abs(cell.grey - light) > kOff * light) {
      cell.weight = 0.0F;
      left_out = true;
    }
  }
  if (left_out) (void)solve(cells, kTerms);  // too few left: the first surface stands
  return true;
}

bool LightSurface::fitUnknown(std::span<Cell> cells) {
  const auto before = c_;
  const bool found = findUnknown(cells);
  if (!found) c_ = before;
  return found;
}

bool LightSurface::findUnknown(std::span<Cell> cells) {
  for (Cell& cell : cells) cell.weight = 1.0F;
  // A slope first, then curved, each time pulled towards the bright side.
  for (const int count : {3, 3, 3, 6, 6, 6}) {
    if (!solve(cells, count)) return false;
    for (Cell& cell : cells) cell.weight = cell.grey >= at(cell.u, cell.v) * (1.0F - 0.5F * kOff) ? 1.0F : kBelowWeight;
  }
  for (Cell& cell : cells) cell.weight = cell.grey >= at(cell.u, cell.v) * (1.0F - kOff) ? 1.0F : 0.0F;
  return fit(cells);
}

float LightSurface::at(float u, float v) const {
  const auto t = terms(u, v);
  float sum = 0.0F;
  for (std::size_t i = 0; i < t.size(); ++i) sum += c_[i] * t[i];
  return std::max(sum, 1.0F);
}

void LightSurface::row(int y, int first, int count, float factor, float* __restrict__ out) const {
  const float v = toV(static_cast<float>(y));
  const float v2 = v * v;
  const float p0 = factor * (c_[0] + v * c_[2] + v2 * (c_[5] + v * c_[7] + v2 * c_[8]));
  const float p1 = factor * (c_[1] + v * c_[4] + v2 * c_[6]);
  const float p2 = factor * (c_[3] + v * c_[7] + 2.0F * v2 * c_[8]);
  const float p3 = factor * c_[6];
  const float p4 = factor * c_[8];
  const float middle = middle_x_;  // locals: `out` could alias members
  const float scale = scale_;
  for (int i = 0; i < count; ++i) {
    const float u = (static_cast<float>(first + i) - middle) * scale;
    const float light = p0 + u * (p1 + u * (p2 + u * (p3 + u * p4)));
    out[i] = light > 1.0F ? light : 1.0F;
  }
}

}  // namespace fyd::sensing
