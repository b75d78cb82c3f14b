#include "widgets/curves/curve_plot.h"

namespace fyd::widgets {

void CurvePlot::setPlotBackground(const QColor& ground) {
  ground_ = ground;
  update();
}

void CurvePlot::paintEvent(QPaintEvent* /*event*/) {
  // The axis labels are cached as pixmaps for one scale of the screen.
  if (!qFuzzyCompare(bufferDevicePixelRatio(), devicePixelRatioF())) setBufferDevicePixelRatio(devicePixelRatioF());
  QCPPainter painter(this);
  painter.fillRect(rect(), ground_);
  draw(&painter);
}

void CurvePlot::resizeEvent(QResizeEvent* /*event*/) {
  setViewport(rect());
  updateLayout();  // the number of columns is needed before the first drawing
  update();
}

}  // namespace fyd::widgets
