// Finds points that the others contradict, even when several outliers mask each other.
//
// Least trimmed squares finds the half of the points that agree best; then the half grows by the next best point as
// long as Student's t allows it (forward search [Hadi 1993]). Studentised residuals of one fit over
// all points would miss outliers that pull the curve to themselves. Nothing is removed here: rows are named.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace fyd::calibration {

struct OutlierOptions {
  double least_sigma = 0.0;  ///< the points' known noise, in y's unit: agreement closer than that proves nothing
  double confidence = 0.99;  ///< probability that no point of a good set is named
};

/// Rows, rising. Empty when there are too few points to tell (fewer than three more than the unknowns), or when a value
/// is not finite. The same input gives the same answer.
/// @param design,y as for fitLinear, each row already multiplied by the root of its weight
[[nodiscard]] std::vector<std::size_t> findOutliers(const Eigen::MatrixXd& design, const Eigen::VectorXd& y,
                                                    const OutlierOptions& options);

}  // namespace fyd::calibration
