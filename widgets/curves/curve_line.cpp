#include "widgets/curves/curve_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace fyd::widgets {
namespace {

constexpr double kFar_px = 1e6;  // beyond every screen; bounds values before they are converted to int

/// Rounds to the nearest; faster than a call of std::lround, of which a curve needs thousands. @param value within
/// kFar_px
// NOLINTNEXTLINE(bugprone-incorrect-roundings): of a half it matters to no pixel which way it goes
int nearest(double value) { return static_cast<int>(value + kFar_px + 0.5) - static_cast<int>(kFar_px); }

constexpr std::size_t kBlock = 8;  // columns

/// What the line covers of each column, as rectangles. A column is as wide as the line: narrower ones would lie on each
/// other. Places across are counted in columns, heights in pixels of the screen.
class Columns {
 public:
  /// @param count of the columns that can be seen
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): of block_ only the first block_size_ are read
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

  /// Ends a connected piece of the line.
  void finish() {
    if (block_size_ == 0) return;
    // The rows that all columns of the block cover are one rectangle: one wide fill is faster than many narrow ones.
    const std::span block = std::span(block_).first(block_size_);
    const int above = line_width_ / 2;
    const int below = line_width_ - 1 - above;
    const int low = std::ranges::max(block, {}, &Column::low).low;
    const int high = std::ranges::min(block, {}, &Column::high).high;
    const bool common = low <= high;
    if (common) put(block.front().x, static_cast<int>(block.size()), low - above, high + below);
    for (const Column& column : block) {
      if (!common) {
        put(column.x, 1, column.low - above, column.high + below);
        continue;
      }
      put(column.x, 1, column.low - above, low - above - 1);
      put(column.x, 1, high + below + 1, column.high + below);
    }
    block_size_ = 0;
  }

  [[nodiscard]] const QVector<QRect>& rectangles() const { return rectangles_; }

 private:
  struct Column {
    int x;
    int low;
    int high;
  };

  void reach(int x, double from, double to) {
    const auto [low, high] = std::minmax({nearest(from), nearest(to)});
    if (block_size_ > 0) {
      Column& last = block_[block_size_ - 1];
      if (last.x == x) {
        last.low = std::min(last.low, low);
        last.high = std::max(last.high, high);
        return;
      }
      if (block_size_ == block_.size() || last.x + 1 != x) finish();
    }
    block_[block_size_++] = {x, low, high};
  }

  /// From the first of the rows to the last, the line's width included.
  void put(int x, int columns, int from, int to) {
    if (to < from) return;
    rectangles_.append(QRect(x * line_width_ - line_width_ / 2, from, columns * line_width_, to - from + 1));
  }

  int count_;
  int line_width_;
  QPointF at_;
  int at_column_ = 0;
  std::array<Column, kBlock> block_;  ///< side by side
  std::size_t block_size_ = 0;
  QVector<QRect> rectangles_;
};

bool isFinite(QPointF point) { return std::isfinite(point.x()) && std::isfinite(point.y()); }

}  // namespace

int lineWidth_px(double width, double scale) { return std::max(1, nearest(width * scale)); }

void CurveLine::drawLinePlot(QCPPainter* painter, const QVector<QPointF>& points) const {
  applyDefaultAntialiasingHint(painter);
  const QPen pen = painter->pen();
  if (pen.style() != Qt::SolidLine || pen.color().alpha() < 255 || painter->antialiasing() ||
      painter->modes().testFlag(QCPPainter::pmVectorized) || !painter->transform().isIdentity()) {
    QCPGraph::drawLinePlot(painter, points);
    return;
  }
  const double scale = painter->device()->devicePixelRatioF();
  const int line_width = lineWidth_px(pen.widthF(), scale);
  const double across = scale / line_width;
  Columns columns(nearest(parentPlot()->viewport().width() * across), line_width);
  bool down = false;
  for (const QPointF& point : points) {
    if (!isFinite(point)) {
      columns.finish();
      down = false;
      continue;
    }
    const QPointF pixel(std::clamp(point.x() * across, -kFar_px, kFar_px),
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
