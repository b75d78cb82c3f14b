// The radius share and the tension ratio of a cloth (core/sensing/contact_cloth.h), fitted to presses over the sensors:
// least squares (Levenberg and Marquardt) on logarithms, each press with an unknown depth of its own, with the usual
// values as a weak prior.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "core/calibration/calibration_result.h"
#include "core/sensing/contact_cloth.h"

namespace fyd::calibration {

/// Noise of a mean of readings; used for the weights, not for the uncertainty.
inline constexpr double kPressNoise_mm = 0.03;

struct ClothPress {
  sensing::Contact contact;
  std::array<sensing::Drop, sensing::kMaximumIrSensors> drops{};
  std::size_t row = 0;   ///< in the samples
  std::size_t over = 0;  ///< the sensor under the finger
};

/// Logarithms, so that radius share and tension ratio stay positive.
struct ClothUnknowns {
  double log_share = 0.0;  ///< of the contact's effective radius over its radius
  double log_ratio = 0.0;  ///< of the tension left to right over that front to back
};

/// A cloth with these edges and unknowns.
class ClothModel {
 public:
  ClothModel(const sensing::IndentationParameters& profile, sensing::ClothEdges edges, ClothUnknowns at);

  /// Adds (reading − share·indentation)/σ of each sensor that reads.
  void residuals(const ClothPress& press, std::size_t sensors, std::vector<double>& out);

  /// The depth by the sensor under the finger, and how well it predicts the readings of the sensors beside it.
  struct Prediction {
    double depth_mm = 0.0;
    double error_mm = 0.0;  ///< root mean square over the sensors beside; NaN: none reads
  };
  [[nodiscard]] Prediction predict(const ClothPress& press, std::size_t sensors);

 private:
  double share_sigma_;
  sensing::ContactCloth cloth_;
};

struct ClothFit {
  ClothUnknowns at;
  double cost = 0.0;  ///< sum of the squared residuals
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Constant(kUnknown);
  double condition_number = kUnknown;
  std::vector<double> residuals;
};

class ClothFitter {
 public:
  /// @param profile outlives the fitter
  ClothFitter(const sensing::IndentationParameters& profile, std::size_t sensors)
      : profile_(profile), sensors_(sensors) {}

  /// @return none unless there are more readings than unknowns (one depth a press, share and ratio)
  [[nodiscard]] std::optional<ClothFit> fit(const std::vector<ClothPress>& presses, sensing::ClothEdges edges) const;

  [[nodiscard]] ClothModel model(sensing::ClothEdges edges, ClothUnknowns at) const { return {profile_, edges, at}; }
  [[nodiscard]] std::size_t sensors() const { return sensors_; }

 private:
  [[nodiscard]] std::vector<double> residuals(const std::vector<ClothPress>& presses, sensing::ClothEdges edges,
                                              ClothUnknowns at) const;
  /// Takes `at` as the best when its cost is lower than the best so far.
  void takeIfBetter(ClothFit& best, const std::vector<ClothPress>& presses, sensing::ClothEdges edges,
                    ClothUnknowns at) const;
  [[nodiscard]] Eigen::MatrixX2d jacobian(const std::vector<ClothPress>& presses, sensing::ClothEdges edges,
                                          ClothUnknowns at) const;

  const sensing::IndentationParameters& profile_;
  std::size_t sensors_;
};

}  // namespace fyd::calibration
