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
  std::size_t row = 0;
  std::size_t over = 0;  ///< the sensor under the finger
};

/// Logarithms, so that no step makes them negative.
struct ClothUnknowns {
  double log_share = 0.0;
  double log_ratio = 0.0;
};

/// A cloth with these edges and unknowns.
class ClothModel {
 public:
  ClothModel(const sensing::IndentationParameters& profile, sensing::ClothEdges edges, ClothUnknowns at);

  /// Adds (reading − share·indentation)/σ of each sensor that reads.
  void residuals(const ClothPress& press, std::size_t sensors, std::vector<double>& out);

  /// Readings of the sensors beside the finger, predicted from the one under it.
  struct Foretold {
    double depth_mm = 0.0;
    double error_mm = 0.0;  ///< root mean square over the sensors beside; NaN: none reads
  };
  [[nodiscard]] Foretold foretell(const ClothPress& press, std::size_t sensors);

 private:
  double share_sigma_;
  sensing::ContactCloth cloth_;
};

struct ClothFit {
  ClothUnknowns at;
  double cost = 0.0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Constant(kUnknown);
  double condition_number = kUnknown;
  std::vector<double> residuals;
};

class ClothFitter {
 public:
  /// @param profile outlives the fitter
  ClothFitter(const sensing::IndentationParameters& profile, std::size_t sensors)
      : profile_(profile), sensors_(sensors) {}

  /// @return none when the presses have fewer readings than unknowns
  [[nodiscard]] std::optional<ClothFit> fit(const std::vector<ClothPress>& presses, sensing::ClothEdges edges) const;

  [[nodiscard]] ClothModel model(sensing::ClothEdges edges, ClothUnknowns at) const { return {profile_, edges, at}; }
  [[nodiscard]] std::size_t sensors() const { return sensors_; }

 private:
  [[nodiscard]] std::vector<double> residuals(const std::vector<ClothPress>& presses, sensing::ClothEdges edges,
                                              ClothUnknowns at) const;
  /// Takes `at` as the best when its cost is lower than the best so far.
  void attempt(ClothFit& best, const std::vector<ClothPress>& presses, sensing::ClothEdges edges,
               ClothUnknowns at) const;
  [[nodiscard]] Eigen::MatrixX2d jacobian(const std::vector<ClothPress>& presses, sensing::ClothEdges edges,
                                          ClothUnknowns at) const;

  const sensing::IndentationParameters& profile_;
  std::size_t sensors_;
};

}  // namespace fyd::calibration
