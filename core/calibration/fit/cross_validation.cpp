#include "core/calibration/fit/cross_validation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fyd::calibration {
namespace {

constexpr std::size_t kFolds = 10;

}  // namespace

std::vector<double> distinctValues(std::span<const double> values, double tolerance) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> out;
  for (const double value : sorted) {
    if (out.empty() || value - out.back() > tolerance) out.push_back(value);
  }
  return out;
}

std::vector<std::size_t> foldsByTarget(std::span<const double> targets, double same, Ends ends) {
  std::vector<std::size_t> folds(targets.size(), kNeverHeldOut);
  const std::vector<double> distinct = distinctValues(targets, same);
  const std::size_t skip = ends == Ends::kept ? 1 : 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const auto above = std::upper_bound(distinct.begin(), distinct.end(), targets[i]);
    const auto group = static_cast<std::size_t>(above - distinct.begin()) - 1;
    if (group < skip || group + skip >= distinct.size()) continue;
    folds[i] = (group - skip) % kFolds;
  }
  return folds;
}

std::vector<std::size_t> foldsByOrder(std::size_t points) {
  std::vector<std::size_t> folds(points);
  for (std::size_t i = 0; i < points; ++i) folds[i] = i % kFolds;
  return folds;
}

std::vector<std::size_t> foldsByGroup(std::span<const std::size_t> groups) {
  std::vector<std::size_t> order(groups.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t point) { return groups[point]; });
  std::vector<std::size_t> folds(groups.size());
  for (std::size_t place = 0; place < order.size(); ++place) folds[order[place]] = place % kFolds;
  return folds;
}

Gap widestGap(std::span<const double> values, double from, double to) {
  std::vector<double> marks = {from};
  for (const double value : values) {
    if (value > from && value < to) marks.push_back(value);
  }
  marks.push_back(to);
  std::sort(marks.begin(), marks.end());
  Gap widest{from, from};
  for (std::size_t i = 1; i < marks.size(); ++i) {
    if (marks[i] - marks[i - 1] > widest.width()) widest = {marks[i - 1], marks[i]};
  }
  return widest;
}

}  // namespace fyd::calibration
