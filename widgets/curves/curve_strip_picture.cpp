// Painting a curve for an export.
#include <cmath>

#include "widgets/curves/curve_plot.h"
#include "widgets/curves/curve_strip.h"

namespace fyd::widgets {
namespace {

/// Point of the line from `a` to `b` at a value between theirs.
QCPGraphData meeting(const QCPGraphData& a, const QCPGraphData& b, double value) {
  return {a.key + (value - a.value) / (b.value - a.value) * (b.key - a.key), value};
}

/// The line cut off where it leaves the range.
QVector<QCPGraphData> within(const QCPGraphDataContainer& line, QCPRange range) {
  QVector<QCPGraphData> out;
  for (auto b = line.constBegin(); b != line.constEnd(); ++b) {
    if (b == line.constBegin()) continue;
    const auto a = b - 1;
    const bool both_outside = std::max(a->value, b->value) < range.lower || std::min(a->value, b->value) > range.upper;
    if (!std::isfinite(a->value) || !std::isfinite(b->value) || both_outside) continue;
    const auto cut = [&](const QCPGraphData& end) {
      const double value = std::clamp(end.value, range.lower, range.upper);
      return value == end.value ? end : meeting(*a, *b, value);
    };
    const QCPGraphData from = cut(*a);
    const bool goes_on = !out.isEmpty() && out.constLast().key == from.key && out.constLast().value == from.value;
    if (!goes_on) {
      if (!out.isEmpty()) out.append({from.key, std::nan("")});
      out.append(from);
    }
    out.append(cut(*b));
  }
  return out;
}

}  // namespace

void CurveStrip::paintTo(QCPPainter& painter, QSize size) {
  // Qt's SVG output does not clip, so curves are cut at the strip's range here.
  for (std::size_t i = 0; i < traces_.size(); ++i) {
    QCPGraph* graph = plot_->graph(static_cast<int>(i));
    graph->data()->set(within(*graph->data(), plot_->yAxis->range()), true);
  }
  plot_->toPainter(&painter, size.width(), size.height());
}

}  // namespace fyd::widgets
