// Linear least squares with covariance, leverage and condition number.
//
//   minimise Σ wᵢ (yᵢ − Σⱼ Aᵢⱼ xⱼ)²
//
// Columns are scaled to length 1 and solved by Householder QR, never by normal equations, which square the condition
// number. The condition number is that of the scaled design, so it depends on the data and not on the units.
#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "core/base/error.h"

namespace fyd::calibration {

struct LinearFit {
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd covariance;  ///< of the coefficients; NaN without degrees of freedom
  Eigen::VectorXd residuals;   ///< measured less fitted, in y's unit, unweighted
  Eigen::VectorXd leverage;    ///< 0…1, influence of each point on its own fitted value
  double sigma = 0.0;          ///< standard deviation of a point of weight 1; NaN without degrees of freedom
  double rmse = 0.0;           ///< √(Σr²/n)
  double max_residual = 0.0;   ///< largest |r|
  double condition_number = 0.0;
  std::size_t degrees_of_freedom = 0;

  [[nodiscard]] double standardError(Eigen::Index i) const;
};

/// Above this the coefficients are not determined in double precision with any margin.
inline constexpr double kSolvableCondition = 1e10;

/// @param weights ≥ 0, one per row; empty: all 1
/// @return an error for values that are not finite, fewer rows than columns, or columns that cannot be told apart
[[nodiscard]] Result<LinearFit> fitLinear(const Eigen::MatrixXd& design, const Eigen::VectorXd& y,
                                          const Eigen::VectorXd& weights = {});

/// The coefficients on another basis, map·x, and their covariance, map·C·mapᵀ.
struct LinearImage {
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd covariance;
};
[[nodiscard]] LinearImage imageOf(const LinearFit& fit, const Eigen::MatrixXd& map);

}  // namespace fyd::calibration
