#include "widgets/devices/picture_pick.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

constexpr double kCross_px = 9.0;
constexpr double kFarStep_px = 10.0;  // with Shift

void cross(QPainter& painter, QPointF at, double reach, const QColor& colour, double width) {
  // Visible on dark and light cloth: a dark line below the coloured one.
  for (const auto& [pen, thick] : {std::pair{QColor(0, 0, 0, 180), width + 2.0}, std::pair{colour, width}}) {
    painter.setPen(QPen(pen, thick));
    painter.drawLine(at - QPointF(reach, 0), at + QPointF(reach, 0));
    painter.drawLine(at - QPointF(0, reach), at + QPointF(0, reach));
  }
}

}  // namespace

PicturePick::PicturePick(QWidget* parent) : QWidget(parent), empty_text_(tr("No picture yet.")) {
  setObjectName(QStringLiteral("picture_pick"));
  setAccessibleName(tr("Camera picture: click a place, or move it with the arrow keys"));
  setMinimumSize(200, 150);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::CrossCursor);
  connect(&Look::instance(), &Look::changed, this, [this] { update(); });
}

void PicturePick::setPicture(const QImage& picture) {
  picture_ = picture;
  if (picture_.isNull()) pressed_.reset();
  update();
}

void PicturePick::setEmptyText(const QString& text) {
  empty_text_ = text;
  update();
}

void PicturePick::showMissing(const QString& text) {
  setPicture({});
  setPlace({});
  setEmptyText(text);
}

void PicturePick::setKind(PickKind kind) {
  kind_ = kind;
  pressed_.reset();
  update();
}

void PicturePick::setMarks(std::vector<QPointF> marks) {
  marks_ = std::move(marks);
  update();
}

void PicturePick::setPlace(std::optional<QPointF> place_px) {
  place_ = place_px;
  update();
}

void PicturePick::setRectangle(const QRect& rectangle_px) {
  rectangle_ = rectangle_px;
  update();
}

QRectF PicturePick::target() const {
  const QSizeF fitted = QSizeF(picture_.size()).scaled(QSizeF(size()), Qt::KeepAspectRatio);
  return {QPointF((width() - fitted.width()) / 2, (height() - fitted.height()) / 2), fitted};
}

QPointF PicturePick::drawnAt(QPointF picture_px) const {
  const QRectF area = target();
  const double s = area.width() / std::max(1, picture_.width());
  return area.topLeft() + (picture_px + QPointF(0.5, 0.5)) * s;
}

QPointF PicturePick::pictureAt(QPointF widget_px) const {
  const QRectF area = target();
  const double s = picture_.width() / std::max(1.0, area.width());
  const QPointF at = (widget_px - area.topLeft()) * s - QPointF(0.5, 0.5);
  return {std::clamp(at.x(), 0.0, picture_.width() - 1.0), std::clamp(at.y(), 0.0, picture_.height() - 1.0)};
}

void PicturePick::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (picture_.isNull()) {
    painter.setPen(theme().muted);
    painter.drawText(rect().adjusted(kGrid, kGrid, -kGrid, -kGrid), Qt::AlignCenter | Qt::TextWordWrap, empty_text_);
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRectF area = target();
  painter.drawImage(area, picture_);
  if (!rectangle_.isEmpty()) {
    const double s = area.width() / picture_.width();
    const QRectF drawn(area.topLeft() + QPointF(rectangle_.topLeft()) * s, QSizeF(rectangle_.size()) * s);
    painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, width] : {std::pair{QColor(0, 0, 0, 180), 4.0}, std::pair{QColor(Qt::white), 2.0}}) {
      painter.setPen(QPen(colour, width));
      painter.drawRect(drawn);
    }
  }
  for (const QPointF& mark : marks_) cross(painter, drawnAt(mark), kCross_px / 2, Qt::white, 1.5);
  if (place_ && kind_ == PickKind::place) cross(painter, drawnAt(*place_), kCross_px, theme().indentation, 2.0);
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme().accent, 2));
    painter.drawRect(area.adjusted(1, 1, -1, -1));
  }
}

void PicturePick::pick(QPointF picture_px) {
  place_ = picture_px;
  update();
  emit placePicked(picture_px);
}

void PicturePick::mousePressEvent(QMouseEvent* event) {
  if (picture_.isNull() || event->button() != Qt::LeftButton) return;
  if (kind_ == PickKind::place) {
    pick(pictureAt(event->position()));
  } else {
    pressed_ = pictureAt(event->position());
  }
}

void PicturePick::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) return;
  const QPoint a = pressed_->toPoint();
  const QPoint b = pictureAt(event->position()).toPoint();
  // Both corners' pixels are within it, whichever way it is dragged: QRect::normalized() takes them away.
  setRectangle(QRect(QPoint(std::min(a.x(), b.x()), std::min(a.y(), b.y())),
                     QPoint(std::max(a.x(), b.x()), std::max(a.y(), b.y()))));
}

void PicturePick::mouseReleaseEvent(QMouseEvent* event) {
  if (!pressed_ || event->button() != Qt::LeftButton) return;
  mouseMoveEvent(event);
  pressed_.reset();
  emit rectanglePicked(rectangle_);
}

void PicturePick::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? kFarStep_px : 1.0;
  QPointF by;
  switch (event->key()) {
    case Qt::Key_Left: by = {-step, 0}; break;
    case Qt::Key_Right: by = {step, 0}; break;
    case Qt::Key_Up: by = {0, -step}; break;
    case Qt::Key_Down: by = {0, step}; break;
    default: QWidget::keyPressEvent(event); return;
  }
  if (picture_.isNull()) return;
  if (kind_ == PickKind::rectangle) {
    if (rectangle_.isEmpty()) return;
    const QSize room = (picture_.size() - rectangle_.size()).expandedTo(QSize(0, 0));
    const QPoint to = rectangle_.topLeft() + by.toPoint();
    rectangle_.moveTo(std::clamp(to.x(), 0, room.width()), std::clamp(to.y(), 0, room.height()));
    rectangle_ &= picture_.rect();  // one that was larger than the picture
    update();
    emit rectanglePicked(rectangle_);
    return;
  }
  const QPointF at = place_.value_or(QPointF(picture_.width() / 2.0, picture_.height() / 2.0)) + by;
  pick({std::clamp(at.x(), 0.0, picture_.width() - 1.0), std::clamp(at.y(), 0.0, picture_.height() - 1.0)});
}

}  // namespace fyd::widgets
