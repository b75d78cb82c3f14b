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
/// @param dot length of a line that is seen as a dot: of a single point between two gaps QCustomPlot draws nothing
QVector<QCPGraphData> within(const QCPGraphDataContainer& line, QCPRange range, double dot) {
  QVector<QCPGraphData> out;
  for (auto b = line.constBegin(); b != line.constEnd(); ++b) {
    const bool begins = b == line.constBegin() || !std::isfinite((b - 1)->value);
    const bool ends = b + 1 == line.constEnd() || !std::isfinite((b + 1)->value);
    if (begins && ends && range.contains(b->value)) {
      if (!out.isEmpty()) out.append({b->key, std::nan("")});
      out.append(*b);
      out.append({b->key + dot, b->value});
    }
    if (begins) continue;
    const auto a = b - 1;
    const bool both_outside = std::max(a->value, b->value) < range.lower || std::min(a->value, b->value) > range.upper;
    if (!std::isfinite(b->value) || both_outside) continue;
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
  // Qt's SVG output does not clip, so curves are cut at the strip's range here; the window keeps the whole ones.
  constexpr double kDot_px = 1.0 / 64.0;  // the line's ends reach beyond it by half the line's width
  const double dot = kDot_px * plot_->xAxis->range().size() / std::max(1, plot_->axisRect()->width());
  std::vector<QSharedPointer<QCPGraphDataContainer>> whole;
  for (std::size_t i = 0; i < traces_.size(); ++i) {
    QCPGraph* graph = plot_->graph(static_cast<int>(i));
    whole.push_back(graph->data());
    const auto cut = QSharedPointer<QCPGraphDataContainer>::create();
    cut->set(within(*whole.back(), plot_->yAxis->range(), dot), true);
    graph->setData(cut);
  }
  plot_->toPainter(&painter, size.width(), size.height());
  for (std::size_t i = 0; i < traces_.size(); ++i) plot_->graph(static_cast<int>(i))->setData(whole[i]);
}

}  // namespace fyd::widgets
