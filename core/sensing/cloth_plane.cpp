#include "core/sensing/cloth_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/portable_math.h"

namespace fyd::sensing {

bool ClothPlane::solve(std::span<const SensorPosition> sensors, std::uint32_t used, double condition_limit) {
  shares_ = {};
  usable_ = false;
  condition_ = std::numeric_limits<double>::infinity();
  const std::size_t count = std::min(sensors.size(), kMaximumIrSensors);
  const auto isUsed = [&](std::size_t i) { return (used >> i & 1U) != 0; };

  double n = 0.0;
  SensorPosition mean;
  for (std::size_t i = 0; i < count; ++i) {
    if (!isUsed(i)) continue;
    n += 1.0;
    mean.x_mm += sensors[i].x_mm;
    mean.y_mm += sensors[i].y_mm;
  }
  if (n < 3.0) return false;
  mean.x_mm /= n;
  mean.y_mm /= n;

  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!isUsed(i)) continue;
    const double x = sensors[i].x_mm - mean.x_mm;
    const double y = sensors[i].y_mm - mean.y_mm;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  // Eigenvalues of C; the smaller one from the determinant, which keeps its digits when it is small.
  const double determinant = xx * yy - xy * xy;
  const double larger = 0.5 * (xx + yy) + math::hypot(0.5 * (xx - yy), xy);
  if (!(determinant > 0.0) || !std::isfinite(larger)) return false;
  condition_ = larger / std::sqrt(determinant);
  if (!(condition_ <= condition_limit)) return false;

  for (std::size_t i = 0; i < count; ++i) {
    if (!isUsed(i)) continue;
    const double x = sensors[i].x_mm - mean.x_mm;
    const double y = sensors[i].y_mm - mean.y_mm;
    shares_[i] = {1.0 / n, (yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant};
  }
  centre_x_mm_ = mean.x_mm;
  centre_y_mm_ = mean.y_mm;
  usable_ = true;
  return true;
}

PlaneWeights ClothPlane::weightsAt(double x_mm, double y_mm) const {
  PlaneWeights out;
  if (!usable_) return out;
  double squares = 0.0;
  for (std::size_t i = 0; i < kMaximumIrSensors; ++i) {
    const Share& share = shares_[i];
    const double w = share.even + (x_mm - centre_x_mm_) * share.along_x + (y_mm - centre_y_mm_) * share.along_y;
    out.weight[i] = w;
    squares += w * w;
  }
  out.noise_gain = std::sqrt(squares);
  return out;
}

double thesisPlane(double z1_mm, double z2_mm, double z3_mm, double x_mm, double y_mm) {
  return 9.0 * z1_mm / 20.0 + z2_mm / 10.0 + 9.0 * z3_mm / 20.0 - x_mm * z1_mm / 44.0 + x_mm * z3_mm / 44.0 -
         y_mm * z1_mm / 60.0 + y_mm * z2_mm / 30.0 - y_mm * z3_mm / 60.0;
}

}  // namespace fyd::sensing
