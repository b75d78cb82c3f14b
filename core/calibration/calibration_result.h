// What every calibration returns: the fit with its uncertainty, a verdict in words and what it would change.
//
// Nothing is changed by computing it. `applyChanges` writes an accepted result into bound parameters, all or nothing.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/parameter.h"

namespace fyd::calibration {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
/// More points than this are refused: no real calibration has them, and the search for outliers would take minutes.
inline constexpr std::size_t kMostPoints = 20'000;

struct Coefficient {
  std::string name;
  std::string unit;
  double value = kUnknown;
  double standard_error = kUnknown;
};

/// One column of the points that were fitted, as they were measured.
struct SampleColumn {
  std::string name;  ///< as in the table that `fyd calibrate` reads
  std::string unit;
  std::vector<double> values;  ///< one for each point
};

/// A parameter and the value it would get, as `assignParameter` reads it.
struct ParameterChange {
  std::string id;
  std::string value;
};

struct Verdict {
  bool accepted = false;
  bool too_few = false;   ///< refused because there are too few points: more of them help
  Message reason;         ///< accepted: what was reached; refused: the cause and what to do next
  std::string threshold;  ///< id of the parameter that decided, empty when none did
};

/// NaN: unknown, because the fit was refused.
struct CalibrationResult {
  std::string procedure;  ///< "ir", "load-cell", …
  Message curve;          ///< the form that was fitted, in words
  std::string unit;       ///< of residuals and errors
  std::size_t points = 0;
  std::vector<SampleColumn> samples;
  std::vector<Coefficient> coefficients;
  double rmse = kUnknown;
  double held_out_rmse = kUnknown;
  double max_residual = kUnknown;
  double condition_number = kUnknown;
  std::string valid_unit;  ///< of valid_from and valid_to: the fit's input
  double valid_from = kUnknown;
  double valid_to = kUnknown;
  std::vector<double> residuals;      ///< measured less fitted, a point's; RMS: a press's (cloth), a chirp's (texture)
  std::vector<std::size_t> outliers;  ///< points the others contradict; kept in the fit unless said otherwise
  std::vector<Message> notes;         ///< what the operator should know beside the verdict
  std::vector<ParameterChange> changes;
  Verdict verdict;
  std::size_t bad_row = kNoRow;  ///< the point that made the samples unusable

  static constexpr std::size_t kNoRow = std::numeric_limits<std::size_t>::max();
};

/// An error of a fit with its unit, as everybody shows it: two significant digits, never with an exponent.
[[nodiscard]] Message errorWithUnit(double value, std::string_view unit);

/// Refuses a result before or after its fit; keeps what is known.
void refuse(CalibrationResult& result, Message reason, std::string_view threshold = {});

/// The same, because there are too few points.
void refuseTooFew(CalibrationResult& result, Message reason, std::string_view threshold);

/// First point that is not finite or outside lowest…highest: refuses the result and names it.
/// @return true when all points are good
[[nodiscard]] bool checkColumn(CalibrationResult& result, std::string_view column, std::span<const double> values,
                               double lowest, double highest);

/// Whether outliers can be the cause of a large error: there are some, but few enough that the other points decide.
[[nodiscard]] bool hasFewOutliers(const CalibrationResult& result);

/// Square root of the mean square, leaving out NaN; NaN when nothing is left.
[[nodiscard]] double rootMeanSquare(std::span<const double> values);

struct AppliedChange {
  std::string id;
  std::string before;
  std::string after;
};

/// Stores every change, or none when one is refused (its message names the parameter and the range).
[[nodiscard]] Result<std::vector<AppliedChange>> applyChanges(std::span<const Parameter> parameters,
                                                              std::span<const ParameterChange> changes);

}  // namespace fyd::calibration
