// A curve on the screen, drawn in one go: QCustomPlot hands the painter a line at a time, which costs more than the
// lines.
#pragma once

#include <qcustomplot.h>

namespace fyd::widgets {

/// The picture is the same pixel for pixel. Dashed lines, those of a scaled screen and those of SVG and PDF are left to
/// QCustomPlot.
class CurveLine : public QCPGraph {
 public:
  using QCPGraph::QCPGraph;

 protected:
  void drawLinePlot(QCPPainter* painter, const QVector<QPointF>& points) const override;
};

}  // namespace fyd::widgets
