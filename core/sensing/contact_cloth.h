// Share of the indentation that each distance sensor sees under a round finger, and the uncertainty of that share.
//
//   zᵢ = −sᵢ(x, y, r)·δ,    r = κ·√(area/π)·(1 + w·δ/2πU)
//
// The shares sᵢ are those of a stretched membrane (membrane.h) with the cloth's tension ratio and edges. A deep press
// stretches the cloth under the finger more than elsewhere, in proportion to its slope (δ/2πU); to distant sensors the
// finger then looks wider (factor w), to sensors beside the contact it does not. The shares have three unknown errors:
// κ depends on the finger's form (0.6 for a sphere, 1 for a flat disc), the tension ratio on how the cloth was clamped,
// and each sensor has an error of its own, because a deeply pressed cloth is not a linear membrane. Errors of κ and of
// the ratio are common to all sensors; averaging over time reduces none of the three.
//
// No allocation; the same bits on every processor.
// Stability: may change
#pragma once

#include <array>
#include <limits>
#include <span>

#include "core/base/api.h"
#include "core/sensing/cloth_plane.h"
#include "core/sensing/indentation_parameters.h"
#include "core/sensing/membrane.h"

namespace fyd::sensing {

/// Where the finger touches the cloth: on the cloth itself, perspective removed.
struct Contact {
  double x_mm = 0.0;
  double y_mm = 0.0;
  double area_mm2 = std::numeric_limits<double>::quiet_NaN();  ///< of the patch; NaN or 0: unknown
};

/// The camera at height H sees what lies δ nearer to it larger by H/(H − δ): the contact from its shadow on the rest
/// plane. A height that is not finite or not above δ removes nothing.
[[nodiscard]] FYD_API Contact withoutPerspective(const Contact& seen, double indentation_mm, double camera_height_mm);

/// One sensor's reading of a press: how far the cloth came nearer to it.
struct Drop {
  double drop_mm = 0.0;
  double sigma_mm = 0.0;  ///< noise of the reading
  bool used = false;
};

/// Indentation from all drops of one moment.
struct ClothDepth {
  double indentation_mm = 0.0;
  double variance_mm2 = std::numeric_limits<double>::infinity();  ///< of noise and shares; infinite: no usable sensor
};

class FYD_API ContactCloth {
 public:
  explicit ContactCloth(const IndentationParameters& parameters = {});

  /// Computes the shares for a finger at this place and depth; kept until the next call.
  void press(const Contact& contact, double indentation_mm);

  /// Least squares, weighted by the noise and, at the depth found so far, by the uncertainty of each share.
  /// @param drops one per sensor
  [[nodiscard]] ClothDepth solve(const Contact& contact, std::span<const Drop> drops);

  [[nodiscard]] std::size_t sensors() const { return sensors_; }
  [[nodiscard]] double share(std::size_t sensor) const { return shares_[sensor].value; }
  /// Standard deviation of one sensor's share, from all three errors.
  [[nodiscard]] double shareSigma(std::size_t sensor) const;
  /// Standard deviation of Σ wᵢ·sᵢ: errors of κ and of the ratio add up, the sensors' own are independent.
  [[nodiscard]] double weightedSigma(std::span<const double> weights) const;
  /// Compliance δ/F here over that under a sphere of 8 mm pressed 3 mm deep in the middle: U here over U there.
  [[nodiscard]] double relativeCompliance() const { return relative_compliance_; }
  /// Standard deviation of its logarithm.
  [[nodiscard]] double logComplianceSigma() const { return log_compliance_sigma_; }

 private:
  struct Share {
    double value = 0.0;
    double by_radius = 0.0;  // signed change with one standard deviation of ln r
    double by_ratio = 0.0;   // … of the tension ratio's logarithm
    double own = 0.0;        // standard deviation of the sensor's own error
  };

  std::size_t sensors_ = 0;
  std::array<SensorPosition, kMaximumIrSensors> positions_{};
  Membrane membrane_;
  Membrane other_ratio_;  // its tension ratio is one standard deviation higher
  double radius_share_ = 1.0;
  double radius_share_sigma_ = 0.0;  // of its logarithm
  double own_sigma_ = 0.0;           // of a share's own error, far from the finger
  double unknown_radius_mm_ = 7.0;
  double middle_level_ = 1.0;  // U of the reference press in the middle
  std::array<Share, kMaximumIrSensors> shares_{};
  double relative_compliance_ = 1.0;
  double log_compliance_sigma_ = 0.0;
};

}  // namespace fyd::sensing
