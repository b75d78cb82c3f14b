#include "widgets/curve_line.h"

#include <algorithm>
#include <cmath>

namespace fyd::widgets {
namespace {

constexpr double kFar_px = 1e6;  // above and below every screen; keeps what becomes an integer in its range

/// To the nearest; std::lround is a call, and a picture has thousands. @param value within kFar_px
int nearest(double value) { return static_cast<int>(value + kFar_px + 0.5) - static_cast<int>(kFar_px); }

/// What the line covers of each column, as rectangles. All in pixels of the screen.
class Columns {
 public:
  /// @param count of the columns that can be seen
  Columns(int count, int line_width) : count_(count), line_width_(line_width) {}

  void moveTo(QPointF point) {
    finish();
    at_ = point;
    at_column_ = nearest(point.x());
    reach(at_column_, point.y(), point.y());
  }

  /// @param point not left of the last one
  void lineTo(QPointF point) {
    const int to_column = nearest(point.x());
    const double slope = point.x() > at_.x() ? (point.y() - at_.y()) / (point.x() - at_.x()) : 0.0;
    for (int x = std::max(at_column_, -1); x <= std::min(to_column, count_); ++x) {
      // A column reaches half its width to either side of its middle.
      const double from = x == at_column_ ? at_.y() : at_.y() + slope * (x - 0.5 - at_.x());
      const double to = x == to_column ? point.y() : at_.y() + slope * (x + 0.5 - at_.x());
      reach(x, from, to);
    }
    at_ = point;
    at_column_ = to_column;
  }

  /// The pen is up.
  void finish() {
    if (open_) put();
    open_ = false;
  }

  [[nodiscard]] const QVector<QRect>& rectangles() const { return rectangles_; }

 private:
  void reach(int x, double from, double to) {
    const auto [low, high] = std::minmax({nearest(from), nearest(to)});
    if (open_ && x == x_) {
      low_ = std::min(low_, low);
      high_ = std::max(high_, high);
      return;
    }
    if (open_) put();
    open_ = true;
    x_ = x;
    low_ = low;
    high_ = high;
  }

  void put() {
    const int half = line_width_ / 2;
    const QRect next(x_ - half, low_ - half, line_width_, high_ - low_ + line_width_);
    const bool goes_on = !rectangles_.isEmpty() && rectangles_.constLast().top() == next.top() &&
                         rectangles_.constLast().height() == next.height() &&
                         rectangles_.constLast().right() >= next.left() - 1;
    if (goes_on) {
      rectangles_.last().setRight(next.right());
    } else {
      rectangles_.append(next);
    }
  }

  int count_;
  int line_width_;
  QPointF at_;
  int at_column_ = 0;
  bool open_ = false;
  int x_ = 0;
  int low_ = 0;
  int high_ = 0;
  QVector<QRect> rectangles_;
};

bool isFinite(QPointF point) { return std::isfinite(point.x()) && std::isfinite(point.y()); }

}  // namespace

void CurveLine::drawLinePlot(QCPPainter* painter, const QVector<QPointF>& points) const {
  applyDefaultAntialiasingHint(painter);
  const QPen pen = painter->pen();
  if (pen.style() != Qt::SolidLine || pen.color().alpha() < 255 || painter->antialiasing() ||
      painter->modes().testFlag(QCPPainter::pmVectorized) || !painter->transform().isIdentity()) {
    QCPGraph::drawLinePlot(painter, points);
    return;
  }
  const double scale = painter->device()->devicePixelRatioF();
  Columns columns(nearest(parentPlot()->viewport().width() * scale), std::max(1, nearest(pen.widthF() * scale)));
  bool down = false;
  for (const QPointF& point : points) {
    if (!isFinite(point)) {
      columns.finish();
      down = false;
      continue;
    }
    const QPointF pixel(std::clamp(point.x() * scale, -kFar_px, kFar_px),
                        std::clamp(point.y() * scale, -kFar_px, kFar_px));
    down ? columns.lineTo(pixel) : columns.moveTo(pixel);
    down = true;
  }
  columns.finish();
  painter->save();
  painter->scale(1.0 / scale, 1.0 / scale);
  painter->setPen(Qt::NoPen);
  painter->setBrush(pen.color());
  painter->drawRects(columns.rectangles());
  painter->restore();
}

}  // namespace fyd::widgets
