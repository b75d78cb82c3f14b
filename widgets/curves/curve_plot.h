// A plot redrawn thirty times a second, painted directly into the window. QCustomPlot itself paints into two buffers
// and composes them, which costs more than drawing the curves.
#pragma once

#include <qcustomplot.h>

namespace fyd::widgets {

/// Shows what it holds with the next update() or repaint(); replot() does nothing for it. Nothing can be selected.
class CurvePlot : public QCustomPlot {
 public:
  explicit CurvePlot(QWidget* parent);
  /// Background colour; opaque.
  void setPlotBackground(const QColor& ground);
  /// The grid and the axes' numbers are kept as a picture while the plot's size and ranges stay: after any other change
  /// of the axes this must be called.
  void axesChanged() { frame_ = QPixmap(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void drawBehind(QCPPainter& painter);  ///< grid and axes
  void drawBefore(QCPPainter& painter);  ///< curves, marks and texts

  QColor ground_ = Qt::white;
  QPixmap frame_;  ///< ground, grid and axes; null: to be drawn
  QCPRange frame_x_;
  QCPRange frame_y_;
};

}  // namespace fyd::widgets
