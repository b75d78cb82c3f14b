// Fast drawing of a curve on the screen. QCustomPlot draws line by line, and Qt's software painter strokes each line as
// an outline on a scaled screen. A curve over time covers one vertical span per column, and filling a rectangle
// is far cheaper.
#pragma once

#include <qcustomplot.h>

namespace fyd::widgets {

/// Of a line as it is drawn: at least one pixel of the screen. @param width of its pen @param scale of the screen
[[nodiscard]] int lineWidth_px(double width, double scale);

/// One rectangle for every column of the line's width that the line passes; a horizontal stretch is a single rectangle. A sample
/// between two gaps is a dot. Dashed or translucent lines, and those of SVG, PDF and other outputs with a
/// transformation, are left to QCustomPlot. The time axis must not be reversed.
class CurveLine : public QCPGraph {
 public:
  using QCPGraph::QCPGraph;

 protected:
  void drawLinePlot(QCPPainter* painter, const QVector<QPointF>& points) const override;
};

}  // namespace fyd::widgets
