#include "widgets/status/simulated_badge.h"

#include <QPainter>

#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

constexpr int kHatch = kGrid;  // px, width of the hatched edge

}  // namespace

SimulatedBadge::SimulatedBadge(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("simulated_badge"));
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(&Look::instance(), &Look::changed, this, qOverload<>(&QWidget::update));
  hide();
}

QSize SimulatedBadge::sizeHint() const {
  const QFontMetrics metrics(textFont(TextSize::small, true));
  return {metrics.horizontalAdvance(words()) + 2 * (kHatch + kGrid), metrics.height() + 4};
}

QString SimulatedBadge::words() const { return tr("SIMULATED: %1").arg(which_); }

void SimulatedBadge::setParts(const std::vector<PartView>& parts) {
  QStringList simulated;
  int devices = 0;
  for (const PartView& part : parts) {
    if (part.origin == PartView::Origin::none) continue;
    ++devices;
    if (part.origin == PartView::Origin::simulated) simulated << part.name;
  }
  const QString which = simulated.isEmpty()           ? QString()
                        : simulated.size() == devices ? tr("all parts")
                                                      : simulated.join(QStringLiteral(", "));
  if (which == which_) return;
  which_ = which;
  setVisible(!which_.isEmpty());
  updateGeometry();
  setAccessibleName(tr("Simulated: %1").arg(which_));
  setToolTip(tr("Simulated: %1. What it shows is computed in this program, not measured on a touchpad.").arg(which_));
  update();
}

void SimulatedBadge::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF frame = QRectF(rect()).adjusted(1, 1, -1, -1);
  painter.setPen(QPen(theme().text, 2));
  painter.drawRoundedRect(frame, 4, 4);
  for (const double left : {frame.left(), frame.right() - kHatch}) {
    painter.fillRect(QRectF(left, frame.top(), kHatch, frame.height()), QBrush(theme().text, Qt::BDiagPattern));
  }
  painter.setFont(textFont(TextSize::small, true));
  painter.drawText(frame, Qt::AlignCenter, words());
}

}  // namespace fyd::widgets
