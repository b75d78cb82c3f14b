#include "widgets/basics/colour_scale.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

constexpr int kBar_px = 12;
constexpr int kMostNumbers = 5;

}  // namespace

ColourScale::ColourScale(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Scale of the colours"));
  connect(&Look::instance(), &Look::changed, this, qOverload<>(&QWidget::update));
}

void ColourScale::setColours(const QGradientStops& stops) {
  stops_ = stops;
  update();
}

void ColourScale::setScale(double least, double largest, const QString& unit) {
  if (least == least_ && largest == largest_ && unit == unit_) return;
  least_ = least;
  largest_ = largest;
  unit_ = unit;
  setAccessibleDescription(tr("%1 to %2 %3").arg(plainNumber(least), plainNumber(largest), unit));
  update();
}

void ColourScale::setMargins(int above_px, int below_px) {
  above_px_ = above_px;
  below_px_ = below_px;
}

void ColourScale::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setFont(textFont(TextSize::small));
  const QFontMetrics metrics = painter.fontMetrics();
  const QRect bar(0, above_px_, kBar_px, height() - above_px_ - below_px_);
  if (bar.height() <= 0) return;
  QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
  gradient.setStops(stops_);
  painter.fillRect(bar, gradient);
  painter.setPen(theme().line);
  painter.drawRect(bar.adjusted(0, 0, -1, -1));
  painter.setPen(theme().muted);
  painter.drawText(0, metrics.ascent(), metrics.elidedText(unit_, Qt::ElideRight, width()));
  // As many numbers as fit, the least and the largest at the bar's ends.
  const int numbers = std::clamp(bar.height() / (2 * metrics.height()) + 1, 2, kMostNumbers);
  const double step = (largest_ - least_) / (numbers - 1);
  const int decimals = step <= 0.0 ? 0 : std::max(0, static_cast<int>(std::ceil(1.0 - std::log10(step))) - 1);
  for (int i = 0; i < numbers; ++i) {
    const int y = bar.bottom() - i * (bar.height() - 1) / (numbers - 1);
    painter.drawText(kBar_px + 4, y + metrics.ascent() / 2 - 1, numberText(least_ + i * step, decimals));
  }
}

}  // namespace fyd::widgets
