#include "widgets/curves/curve_plot.h"

namespace fyd::widgets {
namespace {

constexpr auto kCurves = QLatin1String("curves");  // layer before the axes
constexpr auto kLabels = QLatin1String("overlay");

}  // namespace

CurvePlot::CurvePlot(QWidget* parent) : QCustomPlot(parent) {
  addLayer(kCurves, layer(QLatin1String("axes")));
  setCurrentLayer(kCurves);  // of every curve, mark and text made from here on
}

void CurvePlot::setPlotBackground(const QColor& ground) {
  ground_ = ground;
  axesChanged();
  update();
}

void CurvePlot::drawBehind(QCPPainter& painter) {
  for (const auto name : {kCurves, kLabels}) layer(name)->setVisible(false);
  draw(&painter);
  for (const auto name : {kCurves, kLabels}) layer(name)->setVisible(true);
}

void CurvePlot::drawBefore(QCPPainter& painter) {
  // A curve is hidden with its axis, so the axes stay, without anything to draw.
  const bool numbers[] = {xAxis->tickLabels(), yAxis->tickLabels()};
  for (QCPAxis* axis : {xAxis, yAxis}) {
    axis->grid()->setVisible(false);
    axis->setTickLabels(false);
  }
  draw(&painter);
  for (QCPAxis* axis : {xAxis, yAxis}) {
    axis->grid()->setVisible(true);
    axis->setTickLabels(numbers[axis == yAxis ? 1 : 0]);
  }
}

void CurvePlot::paintEvent(QPaintEvent* /*event*/) {
  QCPPainter painter(this);
  // On paper, in a vector picture or for who reads the texts, numbers stay text.
  if (painter.paintEngine()->type() != QPaintEngine::Raster) {
    painter.fillRect(rect(), ground_);
    drawBehind(painter);
    drawBefore(painter);
    return;
  }
  const double scale = devicePixelRatioF();
  // The axis labels are cached as pixmaps for one scale of the screen.
  if (!qFuzzyCompare(bufferDevicePixelRatio(), scale)) setBufferDevicePixelRatio(scale);
  const QSize pixels = size() * scale;
  if (frame_.size() != pixels || frame_x_ != xAxis->range() || frame_y_ != yAxis->range()) {
    frame_ = QPixmap(pixels);
    frame_.setDevicePixelRatio(scale);
    frame_.fill(ground_);
    frame_x_ = xAxis->range();
    frame_y_ = yAxis->range();
    QCPPainter on_frame(&frame_);
    drawBehind(on_frame);
  }
  painter.drawPixmap(0, 0, frame_);
  drawBefore(painter);
}

void CurvePlot::resizeEvent(QResizeEvent* /*event*/) {
  setViewport(rect());
  updateLayout();  // the number of columns is needed before the first drawing
  update();
}

}  // namespace fyd::widgets
