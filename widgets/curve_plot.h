// A plot that changes thirty times a second: drawn straight into the window. QCustomPlot draws into two pictures of
// its own first and lays them over each other, which costs more than the curves.
#pragma once

#include <qcustomplot.h>

namespace fyd::widgets {

/// Shows what it holds with the next update() or repaint(); replot() does nothing for it. Nothing can be selected.
class CurvePlot : public QCustomPlot {
 public:
  using QCustomPlot::QCustomPlot;
  /// What the curves stand on; opaque.
  void setGround(const QColor& ground);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QColor ground_ = Qt::white;
};

}  // namespace fyd::widgets
