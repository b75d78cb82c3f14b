#include "widgets/curve_line.h"

#include <cmath>

namespace fyd::widgets {

void CurveLine::drawLinePlot(QCPPainter* painter, const QVector<QPointF>& points) const {
  applyDefaultAntialiasingHint(painter);
  // On a scaled screen a line is several pixels wide, and many wide lines at once cost more than one by one.
  if (painter->pen().style() != Qt::SolidLine || painter->antialiasing() ||
      painter->modes().testFlag(QCPPainter::pmVectorized) || painter->device()->devicePixelRatioF() > 1.0) {
    QCPGraph::drawLinePlot(painter, points);
    return;
  }
  const auto finite = [](const QPointF& point) { return std::isfinite(point.x()) && std::isfinite(point.y()); };
  QVector<QLine> lines;
  lines.reserve(points.size());
  for (qsizetype i = 1; i < points.size(); ++i) {
    if (!finite(points[i - 1]) || !finite(points[i])) continue;
    lines.append(QLine(points[i - 1].toPoint(), points[i].toPoint()));
  }
  painter->drawLines(lines);
}

}  // namespace fyd::widgets
