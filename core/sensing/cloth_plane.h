// Plane through the distances of three or more sensors, read at the finger [thesis §4.1.2].
//
//   z(p) = Σ wᵢ(p)·zᵢ,   wᵢ(p) = 1/n + (p − m)·C⁻¹(pᵢ − m),   m = mean of the pᵢ,   C = Σ(pᵢ − m)(pᵢ − m)ᵀ
//
// (least squares, written about the sensors' mean). For the thesis' three positions this is its printed formula,
// exactly. The noise gain |w| is 0.64 at the origin, 1 at a sensor and 2.42 at the corners of the cloth. Nearly
// collinear sensors are refused: the condition number is the square root of the ratio of C's eigenvalues, so 1 is a
// regular triangle whatever its size.
// Stability: may change
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/base/api.h"
#include "core/sensing/readings.h"

namespace fyd::sensing {

struct SensorPosition {
  double x_mm = 0.0;
  double y_mm = 0.0;
};

struct PlaneWeights {
  std::array<double, kMaximumIrSensors> weight{};  ///< 0 for sensors that are left out
  double noise_gain = 0.0;                         ///< √Σw²
};

class FYD_API ClothPlane {
 public:
  /// Solves for the sensors whose bit is set in `used`. Allocation-free.
  /// @return false, and the plane is unusable, with fewer than three of them, or when the condition number exceeds the
  /// limit
  bool solve(std::span<const SensorPosition> sensors, std::uint32_t used, double condition_limit);

  [[nodiscard]] bool usable() const { return usable_; }
  /// Infinite for fewer than three sensors and for sensors on one line.
  [[nodiscard]] double conditionNumber() const { return condition_; }
  /// All zero while the plane is unusable.
  [[nodiscard]] PlaneWeights weightsAt(double x_mm, double y_mm) const;

 private:
  struct Share {
    double even = 0.0;  // 1/n
    double along_x = 0.0;
    double along_y = 0.0;
  };

  std::array<Share, kMaximumIrSensors> shares_{};
  double centre_x_mm_ = 0.0;
  double centre_y_mm_ = 0.0;
  double condition_ = 0.0;
  bool usable_ = false;
};

/// The formula as printed: z of the three distances less their offsets. Pressing makes it negative.
[[nodiscard]] FYD_API double thesisPlane(double z1_mm, double z2_mm, double z3_mm, double x_mm, double y_mm);

}  // namespace fyd::sensing
