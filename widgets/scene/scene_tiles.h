// The set of square tiles of a scene's picture that given rectangles and lines cover.
#pragma once

#include <QPointF>
#include <QSize>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace fyd::widgets {

class SceneTiles {
 public:
  static constexpr int kTile_px = 32;

  void resize(QSize size_px) {
    size_ = size_px;
    columns_ = (size_px.width() + kTile_px - 1) / kTile_px;
    rows_ = (size_px.height() + kTile_px - 1) / kTile_px;
    mark_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 1);
  }
  void clear() { std::ranges::fill(mark_, std::uint8_t{0}); }
  void all() { std::ranges::fill(mark_, std::uint8_t{1}); }
  [[nodiscard]] QSize size() const { return size_; }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] bool at(int column, int row) const {
    return mark_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
  }
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(std::ranges::count(mark_, 1)); }

  void add(QPointF low, QPointF high) {
    const auto tile = [](double px, int most) {
      return static_cast<int>(std::floor(std::clamp(px / kTile_px, -1.0, static_cast<double>(most))));
    };
    for (int row = std::max(0, tile(low.y(), rows_)); row <= std::min(rows_ - 1, tile(high.y(), rows_)); ++row) {
      for (int c = std::max(0, tile(low.x(), columns_)); c <= std::min(columns_ - 1, tile(high.x(), columns_)); ++c) {
        mark_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c)] = 1;
      }
    }
  }

  /// A line as wide as twice `radius_px`.
  void addLine(QPointF from, QPointF to, double radius_px) {
    const QPointF way = to - from;
    const double steps = std::hypot(way.x(), way.y()) / (kTile_px / 2.0);
    if (!(steps < 2000.0)) return all();
    const int n = static_cast<int>(steps) + 1;
    const QPointF wide(radius_px + kTile_px / 4.0, radius_px + kTile_px / 4.0);
    for (int i = 0; i <= n; ++i) {
      const QPointF at = from + way * (static_cast<double>(i) / n);
      add(at - wide, at + wide);
    }
  }

 private:
  QSize size_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::uint8_t> mark_;
};

}  // namespace fyd::widgets
