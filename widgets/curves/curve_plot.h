// A plot redrawn thirty times a second, painted directly into the window. QCustomPlot itself paints into two buffers
// and composes them, which costs more than drawing the curves.
#pragma once

#include <qcustomplot.h>

namespace fyd::widgets {

/// Shows what it holds with the next update() or repaint(); replot() does nothing for it. Nothing can be selected.
class CurvePlot : public QCustomPlot {
 public:
  using QCustomPlot::QCustomPlot;
  /// Background colour; opaque.
  void setPlotBackground(const QColor& ground);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QColor ground_ = Qt::white;
};

}  // namespace fyd::widgets
