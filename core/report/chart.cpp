#include "core/report/chart.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>

#include "core/report/chart_text.h"

namespace fyd::report {
namespace {

constexpr double kNumbers_pt = 7.0;

/// Maps time and value into the part of the box that holds the curves.
struct Scale {
  ChartBox area;
  ChartSpan time;
  double low = 0.0;
  double high = 1.0;

  [[nodiscard]] double x(double time_s) const {
    const double length_s = time.to_s - time.from_s;
    const double share = length_s > 0.0 ? (time_s - time.from_s) / length_s : 0.0;
    return area.x + area.width * std::clamp(share, 0.0, 1.0);
  }
  [[nodiscard]] double y(double value) const { return area.y + area.height * (1.0 - (value - low) / (high - low)); }
};

Scale timeScale(const ChartTime& time, const ChartBox& box) {
  return {.area = {box.x + kChartLeft, box.y + kChartTitle, box.width - kChartLeft, box.height - kChartTitle},
          .time = time.range};
}

void fitValues(Scale& scale, const ChartStrip& strip) {
  double low = 0.0;
  double high = 0.0;
  for (const ChartCurve& curve : strip.curves) {
    for (const recording::MinMax& bucket : curve.values.values) {
      if (std::isfinite(bucket.low)) low = std::min(low, bucket.low);
      if (std::isfinite(bucket.high)) high = std::max(high, bucket.high);
    }
  }
  if (!(high > low)) high = low + 1.0;
  const double room = 0.06 * (high - low);
  scale.low = low < 0.0 ? low - room : 0.0;
  scale.high = high > 0.0 ? high + room : room;
}

void line(cairo_t* cairo, double x1, double y1, double x2, double y2) {
  cairo_move_to(cairo, x1, y1);
  cairo_line_to(cairo, x2, y2);
  cairo_stroke(cairo);
}

void shade(cairo_t* cairo, const Scale& scale, const ChartSpan& span, double least_width) {
  const double left = scale.x(span.from_s);
  cairo_rectangle(cairo, left, scale.area.y, std::max(least_width, scale.x(span.to_s) - left), scale.area.height);
  cairo_fill(cairo);
}

void drawGround(cairo_t* cairo, const ChartTime& time, const Scale& scale) {
  cairo_set_source_rgb(cairo, 0.945, 0.953, 0.961);
  for (const ChartSpan& touch : time.touches) shade(cairo, scale, touch, 0.0);
  cairo_set_source_rgba(cairo, 0.776, 0.125, 0.173, 0.35);
  for (const ChartSpan& gap : time.gaps) shade(cairo, scale, gap, 0.8);
  cairo_set_line_width(cairo, 0.5);
  for (const double value : axisTicks(scale.low, scale.high, 5)) {
    setColour(cairo, kLineRgb);
    line(cairo, scale.area.x, scale.y(value), scale.area.x + scale.area.width, scale.y(value));
    setColour(cairo, kMutedRgb);
    drawText(cairo, scale.area.x - 4.0, scale.y(value) + 2.5, fmt::format("{:g}", value), TextAlign::right);
  }
  for (const ChartMark& mark : time.marks) {
    setColour(cairo, mark.colour);
    line(cairo, scale.x(mark.time_s), scale.area.y, scale.x(mark.time_s), scale.area.y + scale.area.height);
  }
}

/// Whether samples were lost between two times.
bool lostBetween(const std::vector<ChartSpan>& gaps, double from_s, double to_s) {
  return std::ranges::any_of(gaps, [&](const ChartSpan& gap) { return gap.to_s > from_s && gap.from_s < to_s; });
}

void drawCurve(cairo_t* cairo, const ChartCurve& curve, const ChartTime& time, const Scale& scale) {
  setColour(cairo, curve.colour);
  cairo_set_line_width(cairo, curve.dashed ? 1.0 : 0.9);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  const double dashes[] = {4.0, 2.5};
  cairo_set_dash(cairo, dashes, curve.dashed ? 2 : 0, 0.0);
  bool drawing = false;
  for (std::size_t i = 0; i < curve.values.values.size(); ++i) {
    const recording::MinMax& bucket = curve.values.values[i];
    if (!std::isfinite(bucket.low) || !std::isfinite(bucket.high)) {
      drawing = false;
      continue;
    }
    const double x = scale.x(curve.values.time_s[i]);
    // No line across lost samples.
    if (drawing && lostBetween(time.gaps, curve.values.time_s[i - 1], curve.values.time_s[i])) drawing = false;
    // A solid line goes through both extremes, so that a spike of one sample is seen; a dashed one would lose its
    // dashes.
    if (drawing) {
      cairo_line_to(cairo, x, scale.y(bucket.high));
    } else {
      cairo_move_to(cairo, x, scale.y(bucket.high));
    }
    if (!curve.dashed) cairo_line_to(cairo, x, scale.y(bucket.low));
    drawing = true;
  }
  cairo_stroke(cairo);
  cairo_set_dash(cairo, nullptr, 0, 0.0);
}

}  // namespace

std::vector<double> axisTicks(double low, double high, int most) {
  std::vector<double> ticks;
  if (!(high > low) || !std::isfinite(high - low) || most < 1) return ticks;
  const double rough = (high - low) / most;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = power;
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    step = factor * power;
    if (step >= rough) break;
  }
  const double first = std::ceil(low / step);
  for (int i = 0; (first + i) * step <= high && i <= most; ++i) ticks.push_back((first + i) * step + 0.0);
  return ticks;
}

void drawStrip(cairo_t* cairo, const ChartStrip& strip, const ChartTime& time, const ChartBox& box) {
  Scale scale = timeScale(time, box);
  fitValues(scale, strip);
  cairo_save(cairo);
  setFont(cairo, 8.5, true);
  setColour(cairo, strip.colour);
  drawText(cairo, scale.area.x, box.y + kChartTitle - 4.0, strip.title);
  setFont(cairo, kNumbers_pt);
  drawGround(cairo, time, scale);
  cairo_rectangle(cairo, scale.area.x, scale.area.y, scale.area.width, scale.area.height);
  cairo_clip(cairo);
  for (const ChartCurve& curve : strip.curves) drawCurve(cairo, curve, time, scale);
  cairo_restore(cairo);
}

void drawTimeAxis(cairo_t* cairo, const ChartTime& time, const ChartBox& box) {
  const Scale scale = timeScale(time, box);
  const double bottom = box.y + box.height;
  setFont(cairo, kNumbers_pt);
  setColour(cairo, kMutedRgb);
  cairo_set_line_width(cairo, 0.5);
  for (const double second : axisTicks(time.range.from_s, time.range.to_s, 10)) {
    line(cairo, scale.x(second), bottom, scale.x(second), bottom + 3.0);
    drawText(cairo, scale.x(second), bottom + 11.0, fmt::format("{:g}", second), TextAlign::centre);
  }
  drawText(cairo, scale.area.x + scale.area.width / 2.0, bottom + 21.0, time.axis, TextAlign::centre);
}

void drawMarkLabels(cairo_t* cairo, const ChartTime& time, const ChartBox& box, double y) {
  const Scale scale = timeScale(time, box);
  setFont(cairo, kNumbers_pt, true);
  double taken_to = -1.0;
  for (const ChartMark& mark : time.marks) {
    const double width = textWidth(cairo, mark.label);
    const double left = scale.x(mark.time_s) - width / 2.0;
    if (mark.label.empty() || left < taken_to + 2.0) continue;
    setColour(cairo, mark.colour);
    drawText(cairo, left, y, mark.label);
    taken_to = left + width;
  }
}

}  // namespace fyd::report
