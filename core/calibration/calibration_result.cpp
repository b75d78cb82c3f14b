#include "core/calibration/calibration_result.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fyd::calibration {

Message errorWithUnit(double value, std::string_view unit) {
  static constexpr std::array<std::string_view, 7> kFormats = {"{:.0f} {}", "{:.1f} {}", "{:.2f} {}", "{:.3f} {}",
                                                               "{:.4f} {}", "{:.5f} {}", "{:.6f} {}"};
  const bool has_digits = std::isfinite(value) && value != 0.0;
  const double decimals = has_digits ? 1.0 - std::floor(std::log10(std::abs(value))) : 0.0;
  const auto most = static_cast<double>(kFormats.size() - 1);
  Message out(MessageKind::calibration, kFormats[static_cast<std::size_t>(std::clamp(decimals, 0.0, most))]);
  out.add(value);
  if (unit == "deg") {
    out.add(phrase(sentence("deg")));  // the languages of the window write a sign
  } else {
    out.add(std::string(unit));
  }
  return out;
}

void refuse(CalibrationResult& result, Message reason, std::string_view threshold) {
  result.verdict = {.reason = std::move(reason), .threshold = std::string(threshold)};
  result.changes.clear();
}

void refuseTooFew(CalibrationResult& result, Message reason, std::string_view threshold) {
  refuse(result, std::move(reason), threshold);
  result.verdict.too_few = true;
}

bool checkColumn(CalibrationResult& result, std::string_view column, std::span<const double> values, double lowest,
                 double highest) {
  if (values.size() > kMostPoints) {
    refuse(result, say("{} points; at most {}: take fewer, or means", values.size(), kMostPoints));
    return false;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i]) && values[i] >= lowest && values[i] <= highest) continue;
    if (i >= result.bad_row) return false;  // an earlier point is named already
    result.bad_row = i;
    refuse(result, say("{} = {}: expected a number from {} to {}; correct or delete the row", column, values[i], lowest,
                       highest));
    return false;
  }
  return true;
}

bool hasFewOutliers(const CalibrationResult& result) {
  return !result.outliers.empty() && result.outliers.size() * 5 <= result.points;
}

double rootMeanSquare(std::span<const double> values) {
  double largest = 0.0;
  for (const double value : values) {
    if (!std::isnan(value)) largest = std::max(largest, std::abs(value));
  }
  double sum = 0.0;
  std::size_t count = 0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    const double share = largest > 0 ? value / largest : 0.0;
    sum += share * share;
    ++count;
  }
  return count == 0 ? kUnknown : largest * std::sqrt(sum / static_cast<double>(count));
}

Result<std::vector<AppliedChange>> applyChanges(std::span<const Parameter> parameters,
                                                std::span<const ParameterChange> changes) {
  std::vector<AppliedChange> applied;
  const auto undo = [&] {
    std::for_each(applied.rbegin(), applied.rend(), [parameters](const AppliedChange& change) {
      (void)assignParameter(*findParameter(parameters, change.id), change.before);
    });
  };
  for (const ParameterChange& change : changes) {
    const Parameter* parameter = findParameter(parameters, change.id);
    if (parameter == nullptr) {
      undo();
      return fail("{}: no such parameter in this profile", change.id);
    }
    const std::string before = formatParameter(*parameter);
    if (auto assigned = assignParameter(*parameter, change.value); !assigned) {
      undo();
      return tl::unexpected(assigned.error());
    }
    applied.push_back({change.id, before, formatParameter(*parameter)});
  }
  return applied;
}

}  // namespace fyd::calibration
