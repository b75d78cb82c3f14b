// Held-out error: each part of the points is predicted by a fit that has not seen it.
//
// Points at the same target (a distance, a weight) are held out together: a fit that has seen nine readings at 100 mm
// proves nothing by predicting the tenth. Deterministic: the folds follow from the targets alone.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace fyd::calibration {

inline constexpr std::size_t kNeverHeldOut = std::numeric_limits<std::size_t>::max();

enum class Ends { held_out, kept };

/// Fold of each point, 0…k−1. Up to ten targets beyond the ends: one target at a time; more: dealt out over ten folds.
/// @param same targets no farther apart are one: measured values of one distance or weight differ a little
/// @param ends kept: the lowest and the highest target are in every fit, so that the error is one of interpolation
[[nodiscard]] std::vector<std::size_t> foldsByTarget(std::span<const double> targets, double same, Ends ends);

/// Folds dealt out in the given order of the points; for points without repeated targets.
[[nodiscard]] std::vector<std::size_t> foldsByOrder(std::size_t points);

/// Folds dealt out group by group, each group's points in their given order: a group of two points or more is never held
/// out as a whole, in whatever order the points were taken. @param groups the group of each point
[[nodiscard]] std::vector<std::size_t> foldsByGroup(std::span<const std::size_t> groups);

/// @param fit called with the rows to learn from, returns a Result of something
/// @param predict called with that something and a row, returns a double
/// @return the prediction of each row that was held out; NaN where it never was, or where the fit failed
template <class Fit, class Predict>
[[nodiscard]] std::vector<double> predictHeldOut(std::span<const std::size_t> folds, Fit&& fit, Predict&& predict) {
  std::vector<double> out(folds.size(), std::numeric_limits<double>::quiet_NaN());
  std::size_t count = 0;
  for (const std::size_t fold : folds) {
    if (fold != kNeverHeldOut && fold + 1 > count) count = fold + 1;
  }
  for (std::size_t fold = 0; fold < count; ++fold) {
    std::vector<std::size_t> learn;
    for (std::size_t i = 0; i < folds.size(); ++i) {
      if (folds[i] != fold) learn.push_back(i);
    }
    const auto fitted = fit(learn);
    if (!fitted) continue;
    for (std::size_t i = 0; i < folds.size(); ++i) {
      if (folds[i] == fold) out[i] = predict(*fitted, i);
    }
  }
  return out;
}

/// Distinct values, rising; values closer than `tolerance` to the first of a group count as that one.
[[nodiscard]] std::vector<double> distinctValues(std::span<const double> values, double tolerance);

/// The widest part of from…to without a value, as lowest and highest.
struct Gap {
  double from = 0.0;
  double to = 0.0;
  [[nodiscard]] double width() const { return to - from; }
};
[[nodiscard]] Gap widestGap(std::span<const double> values, double from, double to);

}  // namespace fyd::calibration
