#include "widgets/basics/plot_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

constexpr int kFrom_px = 5;     // from the cursor
constexpr int kPadding_px = 2;  // left and right of the text
constexpr int kStep_px = 2;     // of the search for room
constexpr int kAway_cost = 20;  // px of height that are given for standing on the better side

QRect placeOf(const QCPItemText& text) {
  return QRectF(text.topLeft->pixelPosition(), text.bottomRight->pixelPosition()).normalized().toAlignedRect();
}

bool isFree(const QRect& place, const std::vector<QRect>& taken) {
  return std::ranges::none_of(taken, [&](const QRect& each) { return each.intersects(place); });
}

}  // namespace

std::vector<QRect> placeLabels(const QRect& inside, std::vector<QRect> taken, const std::vector<LabelWish>& wishes) {
  int widest = 0;
  for (const LabelWish& wish : wishes) widest = std::max(widest, wish.size.width());
  std::vector<QRect> out;
  for (const LabelWish& wish : wishes) {
    if (wish.size.isEmpty()) {
      out.emplace_back();
      continue;
    }
    const int width = wish.size.width();
    const int right = wish.at.x() + kFrom_px;
    const int left = wish.at.x() - kFrom_px - width;
    const int columns[] = {right, left, right + widest + kFrom_px, left - widest - kFrom_px};
    QRect best;
    int least = std::numeric_limits<int>::max();
    for (int column = 0; column < 4; ++column) {
      for (int y = inside.top(); y + wish.size.height() - 1 <= inside.bottom(); y += kStep_px) {
        const QRect place(QPoint(columns[column], y), wish.size);
        const int cost = std::abs(place.center().y() - wish.at.y()) + column * kAway_cost;
        if (cost >= least || !inside.contains(place) || !isFree(place, taken)) continue;
        least = cost;
        best = place;
      }
    }
    if (best.isValid()) taken.push_back(best);
    out.push_back(best);
  }
  return out;
}

PlotLabels::PlotLabels(QCustomPlot& plot) : QCPLayerable(&plot, QStringLiteral("overlay")) {}

std::vector<QRect> PlotLabels::places() const {
  const QCPAxis& across = *parentPlot()->xAxis;
  std::vector<QRect> taken;
  for (int i = 0; i < parentPlot()->itemCount(); ++i) {
    const auto* text = qobject_cast<const QCPItemText*>(parentPlot()->item(i));
    if (text != nullptr && text->visible()) taken.push_back(placeOf(*text));
  }
  const QFontMetrics metrics(textFont(TextSize::small));
  const QRect inside = parentPlot()->axisRect()->rect();
  std::vector<LabelWish> wishes;
  for (const PlotLabel& label : labels_) {
    if (!across.range().contains(label.at)) {
      wishes.push_back({});
      continue;
    }
    const double x = across.coordToPixel(label.at);
    const double y = std::clamp<double>(parentPlot()->yAxis->coordToPixel(label.height), inside.top(), inside.bottom());
    wishes.push_back(
        {QPointF(x, y).toPoint(), QSize(metrics.horizontalAdvance(label.text) + 2 * kPadding_px, metrics.height())});
  }
  return placeLabels(inside, std::move(taken), wishes);
}

void PlotLabels::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(false); }

void PlotLabels::draw(QCPPainter* painter) {
  if (labels_.empty()) return;
  const std::vector<QRect> where = places();
  painter->setFont(textFont(TextSize::small));
  for (std::size_t i = 0; i < where.size(); ++i) {
    if (!where[i].isValid()) continue;
    painter->fillRect(where[i], theme().panel);
    painter->setPen(labels_[i].colour);
    painter->drawText(where[i], Qt::AlignCenter, labels_[i].text);
  }
}

}  // namespace fyd::widgets
