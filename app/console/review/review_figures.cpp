#include "app/console/review/review_figures.h"

#include <algorithm>
#include <cmath>

namespace fyd::console {
namespace {

constexpr std::uint64_t kBlock = 4096;

/// Sums of one quantity; the time counts from the first mark, so that the least squares lose no digits.
struct Sums {
  double n = 0.0, t = 0.0, tt = 0.0, v = 0.0, vv = 0.0, tv = 0.0;
  double first = pipeline::kNone;
  double last = pipeline::kNone;
  void add(double time_s, double value) {
    if (!std::isfinite(value)) return;
    if (n == 0.0) first = value;
    last = value;
    n += 1.0;
    t += time_s;
    tt += time_s * time_s;
    v += value;
    vv += value * value;
    tv += time_s * value;
  }
  /// @param b_first B lies before A
  [[nodiscard]] StretchFigures figures(bool b_first) const {
    if (n == 0.0) return {};
    const double spread = tt - t * t / n;
    const double at_a = b_first ? last : first;
    const double at_b = b_first ? first : last;
    return {.at_a = at_a,
            .at_b = at_b,
            .difference = at_b - at_a,
            .slope_per_s = spread > 0.0 ? (tv - t * v / n) / spread : pipeline::kNone,
            .mean = v / n,
            .rms = std::sqrt(vv / n)};
  }
};

}  // namespace

Result<std::vector<StretchFigures>> figuresBetween(const recording::Recording& recording, double a_s, double b_s,
                                                   const recording::Progress& progress) {
  if (!std::isfinite(a_s) || !std::isfinite(b_s))
    return fail("figures from {} s to {} s: expected two times", a_s, b_s);
  const bool b_first = b_s < a_s;
  const double from_s = std::min(a_s, b_s);
  const auto first = recording.rowAt(from_s);
  if (!first) return tl::unexpected(first.error());
  const auto end = recording.rowAt(justAfter(std::max(a_s, b_s)));
  if (!end) return tl::unexpected(end.error());
  std::vector<Sums> sums(kReviewQuantities.size());
  std::vector<pipeline::TelemetrySample> rows;
  const auto fields = pipeline::telemetryFields();
  std::array<std::size_t, kReviewQuantities.size()> indexes{};
  std::ranges::transform(kReviewQuantities, indexes.begin(), [](const auto& q) { return fieldIndex(q.field); });
  for (std::uint64_t row = *first; row < *end; row += rows.size()) {
    const double done = static_cast<double>(row - *first) / static_cast<double>(*end - *first);
    if (auto told = recording::tellProgress(progress, done); !told) return tl::unexpected(told.error());
    rows.resize(std::min(kBlock, *end - row));
    if (auto read = recording.telemetry(row, rows); !read) return tl::unexpected(read.error());
    for (const pipeline::TelemetrySample& sample : rows) {
      const double time_s = recording::secondsInto(recording.info(), sample.now) - from_s;
      for (std::size_t q = 0; q < sums.size(); ++q) sums[q].add(time_s, fields[indexes[q]].read(sample));
    }
  }
  std::vector<StretchFigures> out;
  out.reserve(sums.size());
  for (const Sums& each : sums) out.push_back(each.figures(b_first));
  return out;
}

}  // namespace fyd::console
