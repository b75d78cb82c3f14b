#include "widgets/curves/session_overview.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/basics/number_text.h"

namespace fyd::widgets {
namespace {

constexpr double kMarkHeight = 10.0;
constexpr double kTouchHeight = 4.0;
constexpr double kScaleHeight = 16.0;
constexpr double kNear_px = 5.0;

QColor colourOf(OverviewMarkKind kind) {
  switch (kind) {
    case OverviewMarkKind::alarm: return theme().danger;
    case OverviewMarkKind::gap: return theme().warning;
    case OverviewMarkKind::note: return theme().accent;
    case OverviewMarkKind::event: return theme().muted;
  }
  return theme().muted;
}

}  // namespace

SessionOverview::SessionOverview(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("session_overview"));
  setAccessibleName(tr("The whole recording"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setMouseTracking(true);
  connect(&Look::instance(), &Look::changed, this, qOverload<>(&QWidget::update));
}

QRectF SessionOverview::plotRect() const {
  return QRectF(rect()).adjusted(kGrid, kMarkHeight + 2, -kGrid, -kScaleHeight);
}

int SessionOverview::plotWidth_px() const {
  return std::max(1, static_cast<int>(plotRect().width() * devicePixelRatioF()));
}

double SessionOverview::xOf(double time_s) const {
  const QRectF plot = plotRect();
  return duration_s_ > 0.0 ? plot.left() + plot.width() * time_s / duration_s_ : plot.left();
}

double SessionOverview::timeAt(double x_px) const {
  const QRectF plot = plotRect();
  return std::clamp((x_px - plot.left()) / std::max(1.0, plot.width()), 0.0, 1.0) * duration_s_;
}

void SessionOverview::setDuration(double duration_s) {
  duration_s_ = std::isfinite(duration_s) ? std::max(0.0, duration_s) : 0.0;
  setAccessibleDescription(durationText(duration_s_));
  update();
}

void SessionOverview::setTouches(std::vector<std::pair<double, double>> touches_s) {
  touches_s_ = std::move(touches_s);
  update();
}

void SessionOverview::setMarks(std::vector<OverviewMark> marks) {
  marks_ = std::move(marks);
  update();
}

void SessionOverview::setWindow(double from_s, double to_s) {
  from_s_ = from_s;
  to_s_ = to_s;
  update();
}

void SessionOverview::setCursor_s(double time_s) {
  cursor_s_ = time_s;
  update();
}

void SessionOverview::setEnvelope(std::vector<CurveColumn> columns, Quantity quantity) {
  envelope_ = std::move(columns);
  quantity_ = quantity;
  update();
}

void SessionOverview::paintEnvelope(QPainter& painter, const QRectF& plot) const {
  double low = 0.0;
  double high = 0.0;
  for (const CurveColumn& column : envelope_) {
    if (std::isnan(column.minimum)) continue;
    low = std::min<double>(low, column.minimum);
    high = std::max<double>(high, column.maximum);
  }
  if (high <= low) return;
  painter.setPen(QPen(theme().of(quantity_), 1));
  const auto y = [&](double value) { return plot.bottom() - plot.height() * (value - low) / (high - low); };
  for (const CurveColumn& column : envelope_) {
    if (std::isnan(column.minimum)) continue;
    const double x = xOf(column.time_s);
    painter.drawLine(QPointF(x, y(column.minimum)), QPointF(x, std::min(y(column.maximum), y(column.minimum) - 1.0)));
  }
}

void SessionOverview::paintMarks(QPainter& painter, const QRectF& plot) const {
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme().live);
  for (const auto& [from_s, to_s] : touches_s_) {
    const double left = xOf(from_s);
    painter.drawRect(QRectF(left, plot.bottom() + 1.0, std::max(1.0, xOf(to_s) - left), kTouchHeight));
  }
  // A shape for each kind, so that colour is not alone.
  for (const OverviewMark& mark : marks_) {
    const double x = xOf(mark.time_s);
    const QRectF where(x - 3.0, 1.0, 6.0, kMarkHeight - 2.0);
    painter.setBrush(colourOf(mark.kind));
    switch (mark.kind) {
      case OverviewMarkKind::event: painter.drawRect(where.adjusted(2, 0, -2, 0)); break;
      case OverviewMarkKind::note: painter.drawEllipse(where.center(), 3.0, 3.0); break;
      case OverviewMarkKind::gap: painter.drawRect(where); break;
      case OverviewMarkKind::alarm:
        painter.drawPolygon(QPolygonF({where.topLeft(), where.topRight(), QPointF(x, where.bottom())}));
        break;
    }
  }
}

void SessionOverview::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Theme& t = theme();
  const QRectF plot = plotRect();
  painter.fillRect(rect(), t.panel);
  if (duration_s_ <= 0.0) return;
  QColor shown = t.accent;
  shown.setAlpha(40);
  painter.fillRect(QRectF(QPointF(xOf(from_s_), plot.top()), QPointF(xOf(to_s_), plot.bottom())).intersected(plot),
                   shown);
  paintEnvelope(painter, plot);
  painter.setRenderHint(QPainter::Antialiasing);
  paintMarks(painter, plot);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(t.accent, 1));
  painter.drawRect(QRectF(QPointF(xOf(from_s_), plot.top()), QPointF(xOf(to_s_), plot.bottom())).intersected(plot));
  if (box_from_s_)
    painter.drawRect(
        QRectF(QPointF(xOf(*box_from_s_), plot.top()), QPointF(xOf(box_to_s_), plot.bottom())).normalized());
  painter.setPen(QPen(t.text, 1));
  painter.drawLine(QPointF(xOf(cursor_s_), plot.top() - 2), QPointF(xOf(cursor_s_), plot.bottom() + kTouchHeight));
  painter.setPen(t.muted);
  painter.setFont(textFont(TextSize::small));
  const QRectF scale(plot.left(), plot.bottom() + kTouchHeight, plot.width(), kScaleHeight - kTouchHeight + 1);
  painter.drawText(scale, Qt::AlignLeft | Qt::AlignVCenter, tr("0 s"));
  painter.drawText(scale, Qt::AlignRight | Qt::AlignVCenter, durationText(duration_s_));
}

void SessionOverview::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::RightButton) {
    box_from_s_ = box_to_s_ = timeAt(event->position().x());
  } else if (event->button() == Qt::LeftButton) {
    emit cursorAsked(timeAt(event->position().x()));
  }
}

void SessionOverview::mouseMoveEvent(QMouseEvent* event) {
  if (box_from_s_) {
    box_to_s_ = timeAt(event->position().x());
    update();
  } else if (event->buttons().testFlag(Qt::LeftButton)) {
    emit cursorAsked(timeAt(event->position().x()));
  }
}

void SessionOverview::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::RightButton || !box_from_s_) return;
  const auto [from_s, to_s] = std::minmax({*box_from_s_, timeAt(event->position().x())});
  box_from_s_.reset();
  update();
  if (to_s > from_s) emit windowAsked(from_s, to_s);
}

void SessionOverview::resizeEvent(QResizeEvent*) { emit resized(); }

bool SessionOverview::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QStringList words;
  for (const OverviewMark& mark : marks_) {
    if (std::abs(xOf(mark.time_s) - help->pos().x()) <= kNear_px && words.size() < 8) {
      words << tr("%1 s: %2").arg(numberText(mark.time_s, 3), mark.text);
    }
  }
  QToolTip::showText(help->globalPos(),
                     words.isEmpty() ? tr("Click to look there; drag with the right button to choose a stretch.")
                                     : words.join(QLatin1Char('\n')),
                     this);
  return true;
}

}  // namespace fyd::widgets
