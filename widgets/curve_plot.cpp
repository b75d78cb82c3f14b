#include "widgets/curve_plot.h"

namespace fyd::widgets {

void CurvePlot::setGround(const QColor& ground) {
  ground_ = ground;
  update();
}

void CurvePlot::paintEvent(QPaintEvent* /*event*/) {
  // The words at the axes are kept as small pictures, for one scale of the screen.
  if (!qFuzzyCompare(bufferDevicePixelRatio(), devicePixelRatioF())) setBufferDevicePixelRatio(devicePixelRatioF());
  QCPPainter painter(this);
  painter.fillRect(rect(), ground_);
  draw(&painter);
}

void CurvePlot::resizeEvent(QResizeEvent* /*event*/) {
  setViewport(rect());
  updateLayout();  // how many columns there are is asked before the first picture
  update();
}

}  // namespace fyd::widgets
