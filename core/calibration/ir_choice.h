// Chooses the curve that fits a distance sensor's points, and finds the points that the others contradict.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/calibration/calibration_parameters.h"
#include "core/calibration/calibration_result.h"
#include "core/calibration/ir_curve.h"

namespace fyd::calibration {

/// Distances closer than this are one and the same target.
inline constexpr double kSameDistance_mm = 0.25;

/// Result of one candidate, for the table beside the chosen one.
struct IrAttempt {
  IrCandidate candidate = IrCandidate::degree2;
  double rmse_mm = kUnknown;
  double held_out_rmse_mm = kUnknown;
  double condition_number = kUnknown;
  Message problem;  ///< why it cannot be chosen; empty when it can
};

/// The candidates tried on some of the points, and the one to take.
struct IrChoice {
  std::vector<IrAttempt> attempts;
  std::vector<std::size_t> rows;
  IrPoints points;  ///< those rows
  std::optional<IrCurve> curve;
};

/// The simplest curve within 5 % of the least held-out error, among those that fall over their whole span.
[[nodiscard]] IrChoice chooseIrCurve(const IrPoints& all, std::vector<std::size_t> rows,
                                     const CalibrationParameters& parameters);

/// Rows of all points that the others contradict, judged by the curve that is chosen without them.
[[nodiscard]] std::vector<std::size_t> irOutliers(const IrPoints& all, const IrChoice& first,
                                                  const CalibrationParameters& parameters);

[[nodiscard]] std::vector<std::size_t> rowsWithout(std::size_t count, const std::vector<std::size_t>& left_out);

/// Whole codes between the lowest and the highest reading.
[[nodiscard]] std::pair<int, int> codeSpan(const IrPoints& points);

/// Whether the curve falls strictly, and stays above 0 mm, from each code of the span to the next.
[[nodiscard]] bool fallsAtEveryCode(const IrCurve& curve, int lowest_code, int highest_code);

}  // namespace fyd::calibration
