// FingerPath::fromCsv: checks a recorded hand and fits it to the cloth.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/csv.h"
#include "core/base/whole_file.h"
#include "core/sim/finger_path.h"

namespace fyd::sim {
namespace {

constexpr double kSeam_s = 0.5;   // lifted between the end and the next start
constexpr double kLargest = 1e6;  // mm; times may be 1000 times this, s
constexpr double kHighestAsItStands_mm = 20.0;
constexpr double kShareInContact = 0.7;

struct Span {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] bool within(double from, double to) const { return low >= from && high <= to; }
  [[nodiscard]] double middle() const { return 0.5 * (low + high); }
};

Result<void> checkRow(const CsvTable& table, std::size_t row, const std::string& path) {
  const std::size_t line = table.lines[row];
  const double t = table.values[0][row];
  if (!std::isfinite(t) || std::abs(t) > kLargest * 1000.0) {
    return fail("{}:{}: t_s is {}; expected a time in seconds", path, line, t);
  }
  if (row > 0 && !(t > table.values[0][row - 1])) {
    return fail("{}:{}: t_s is {} after {}; time must increase from row to row", path, line, t,
                table.values[0][row - 1]);
  }
  int absent = 0;
  for (std::size_t column = 1; column < 4; ++column) {
    const double value = table.values[column][row];
    if (std::isnan(value)) {
      ++absent;
    } else if (std::abs(value) > kLargest) {
      return fail("{}:{}: {} is {}; expected millimetres within ±{}", path, line, table.columns[column], value,
                  kLargest);
    }
  }
  if (absent != 0 && absent != 3) {
    return fail("{}:{}: {} of x_mm, y_mm, z_mm are NaN; all three mean a lifted finger, otherwise none may be", path,
                line, absent);
  }
  return {};
}

/// How recorded positions become positions on the cloth.
struct Fit {
  double middle_x_mm = 0.0;
  double middle_y_mm = 0.0;
  double scale = 1.0;
  double touch_z_mm = 0.0;  // indentation 0
  double depth_scale = 1.0;

  [[nodiscard]] FingerPath::Knot apply(double time_s, double x_mm, double y_mm, double z_mm) const {
    const double depth = std::clamp((touch_z_mm - z_mm) * depth_scale, -kLargest, kDeepestPress_mm);
    return {.time_s = time_s,
            .state = {.x_mm = (x_mm - middle_x_mm) * scale,
                      .y_mm = (y_mm - middle_y_mm) * scale,
                      .indentation_mm = std::max(depth, 0.0),
                      .lifted = !(depth > 0.0)},
            .above_mm = std::max(-depth, 0.0)};
  }
};

Fit fitOf(const CsvTable& table) {
  Span x;
  Span y;
  Span z;
  std::vector<double> heights;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (std::isnan(table.values[3][row])) continue;
    x.add(table.values[1][row]);
    y.add(table.values[2][row]);
    z.add(table.values[3][row]);
    heights.push_back(table.values[3][row]);
  }
  Fit fit;
  if (heights.empty()) return fit;
  if (x.within(-kUsableHalfWidth_mm, kUsableHalfWidth_mm) && y.within(-kUsableHalfDepth_mm, kUsableHalfDepth_mm) &&
      z.within(-kDeepestPress_mm, kHighestAsItStands_mm)) {
    return fit;
  }
  const auto factor = [](const Span& span, double half) {
    return span.high > span.low ? 2.0 * half / (span.high - span.low) : std::numeric_limits<double>::infinity();
  };
  fit.middle_x_mm = x.middle();
  fit.middle_y_mm = y.middle();
  fit.scale = std::min(factor(x, kUsableHalfWidth_mm), factor(y, kUsableHalfDepth_mm));
  if (!std::isfinite(fit.scale)) fit.scale = 1.0;  // a finger that stays in one place
  const auto nth = static_cast<std::ptrdiff_t>(kShareInContact * static_cast<double>(heights.size() - 1));
  std::nth_element(heights.begin(), heights.begin() + nth, heights.end());
  fit.touch_z_mm = heights[static_cast<std::size_t>(nth)];
  if (fit.touch_z_mm > z.low) {
    fit.depth_scale = kDeepestPress_mm / (fit.touch_z_mm - z.low);
  } else {  // (nearly) all at the lowest height: pressed there, lifted above
    fit.touch_z_mm = z.low + kDeepestPress_mm;
  }
  return fit;
}

}  // namespace

Result<FingerPath> FingerPath::fromCsv(const std::string& path) {
  const auto text = readWholeFile(path, kLargestCsv_bytes, FileKind::pipe_too);
  if (!text) return tl::unexpected(text.error());
  return fromCsvText(*text, path);
}

Result<FingerPath> FingerPath::fromCsvText(std::string_view text, const std::string& source_name) {
  const auto table = parseCsv(text, source_name, {"t_s", "x_mm", "y_mm", "z_mm"});
  if (!table) return tl::unexpected(table.error());
  for (std::size_t row = 0; row < table->rows(); ++row) {
    if (const auto checked = checkRow(*table, row, source_name); !checked) return tl::unexpected(checked.error());
  }
  const Fit fit = fitOf(*table);
  std::vector<FingerPath::Knot> knots;
  knots.reserve(table->rows());
  FingerState place;
  for (std::size_t row = 0; row < table->rows(); ++row) {
    const double z = table->values[3][row], time_s = table->values[0][row] - table->values[0][0];
    if (std::isnan(z)) {  // x and y stay as they were
      knots.push_back({time_s,
                       {.x_mm = place.x_mm, .y_mm = place.y_mm, .indentation_mm = 0.0, .lifted = true},
                       std::numeric_limits<double>::quiet_NaN()});
    } else {
      knots.push_back(fit.apply(time_s, table->values[1][row], table->values[2][row], z));
      place = knots.back().state;
    }
  }
  return FingerPath::fromKnots(std::move(knots));
}

FingerPath FingerPath::fromKnots(std::vector<Knot> knots) {
  FingerPath out;
  out.knots_ = std::move(knots);
  if (out.knots_.size() > 1) out.duration_s_ = out.knots_.back().time_s + kSeam_s;
  return out;
}

}  // namespace fyd::sim
