#include "app/bench/window/spike.h"

#include <QImage>
#include <cstdlib>

#include <qcustomplot.h>

#include "widgets/curves/curve_view.h"

namespace fyd::console::bench {

bool spikeSeen(QCustomPlot& plot, double share, double value, const QColor& colour) {
  const QImage image = plot.grab().toImage();
  const double scale = image.devicePixelRatio();
  const QRect rect = plot.axisRect()->rect();
  const double x = rect.left() + rect.width() * share;
  const double y = plot.yAxis->coordToPixel(value);
  const auto near = [&](const QRgb pixel) {
    const QColor c(pixel);
    return std::abs(c.red() - colour.red()) + std::abs(c.green() - colour.green()) +
               std::abs(c.blue() - colour.blue()) <
           60;
  };
  for (int column = static_cast<int>(scale * (x - 2)); column <= static_cast<int>(scale * (x + 2)); ++column) {
    for (int line = static_cast<int>(scale * (y - 2)); line <= static_cast<int>(scale * (y + 3)); ++line) {
      if (image.valid(column, line) && near(image.pixel(column, line))) return true;
    }
  }
  return false;
}

SpikeCount countSpikes(const widgets::CurveView& view, float value) {
  const widgets::Trace& trace = view.stack()->setup(0).traces.front();
  const widgets::TimeWindow& window = view.stack()->window(0);
  const std::size_t channel[] = {trace.channel};
  const widgets::CurveRows rows = view.buffer().rows(channel, window.from_s(), window.to_s());
  SpikeCount out;
  for (std::size_t i = 0; i < rows.time_s.size(); ++i) {
    if (rows.values[0][i] != value) continue;
    ++out.shown;
    const double share = (rows.time_s[i] - window.from_s()) / window.span_s();
    if (!spikeSeen(*view.strip(0)->plot(), share, value, widgets::theme().of(trace.quantity))) ++out.lost;
  }
  return out;
}

}  // namespace fyd::console::bench
