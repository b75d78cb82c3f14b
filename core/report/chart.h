// A strip chart over time, drawn with cairo: the same on an SVG and a PDF surface. Lengths are points.
#pragma once

#include <string>
#include <vector>

#include "core/recording/reader/recording.h"
#include "core/report/chart_colours.h"
#include "core/report/chart_text.h"

namespace fyd::report {

struct ChartCurve {
  recording::Overview values;  ///< smallest and largest value of each bucket; a bucket without a number is a break
  Rgb colour = kTextRgb;
  bool dashed = false;
};

struct ChartSpan {
  double from_s = 0.0;
  double to_s = 0.0;
};

struct ChartMark {
  double time_s = 0.0;
  Rgb colour = kMutedRgb;
  std::string label;  ///< above the first strip; a label that finds no room is left out
};

/// What all strips of a figure share.
struct ChartTime {
  ChartSpan range;
  std::vector<ChartSpan> touches;  ///< shaded
  std::vector<ChartSpan> gaps;     ///< lost samples
  std::vector<ChartMark> marks;
  std::string axis = "time from the start, s";
};

struct ChartStrip {
  std::string title;  ///< quantity and unit
  Rgb colour = kTextRgb;
  std::vector<ChartCurve> curves;
};

struct ChartBox {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;
};

inline constexpr double kChartLeft = 46.0;   ///< room for the numbers of the vertical axis
inline constexpr double kChartTitle = 16.0;  ///< and for the title above the curves
inline constexpr double kChartAxis = 26.0;   ///< and for the time below the last strip

/// Round numbers, 1, 2 or 5 × a power of ten apart, within [low, high]: at most `most` of them, and one more where both
/// bounds are such numbers. Empty when the bounds are no range.
[[nodiscard]] std::vector<double> axisTicks(double low, double high, int most);

/// `box` holds title and curves. The vertical axis reaches from the smallest to the largest value and holds zero.
void drawStrip(cairo_t* cairo, const ChartStrip& strip, const ChartTime& time, const ChartBox& box);
/// Numbers of the time axis below a strip's box.
void drawTimeAxis(cairo_t* cairo, const ChartTime& time, const ChartBox& box);
/// Labels of the marks, on a line whose baseline is `y`.
void drawMarkLabels(cairo_t* cairo, const ChartTime& time, const ChartBox& box, double y);

}  // namespace fyd::report
