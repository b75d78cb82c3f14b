// A curve on the screen. QCustomPlot hands the painter a line at a time, and Qt's software painter outlines each one
// on a scaled screen; but a curve over time covers one upright stretch of every column of the picture, and a rectangle
// costs next to nothing.
#pragma once

#include <qcustomplot.h>

namespace fyd::widgets {

/// One rectangle for every column of the screen's pixels that the line passes; a level stretch is one altogether.
/// A sample between two gaps is a dot. Lines that are dashed or let shine through, and those of SVG, PDF and other
/// pictures with a transformation, are left to QCustomPlot. The axis of time must not run backwards.
class CurveLine : public QCPGraph {
 public:
  using QCPGraph::QCPGraph;

 protected:
  void drawLinePlot(QCPPainter* painter, const QVector<QPointF>& points) const override;
};

}  // namespace fyd::widgets
