#include "widgets/devices/camera_image.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include "widgets/basics/icon.h"
#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

constexpr QSize kUsualPicture(320, 240);
constexpr double kDepthPerPixel_mm = 0.02;  // Shift and drag

}  // namespace

CameraImage::CameraImage(QWidget* parent) : QWidget(parent), empty_text_(noneYet()) {
  setObjectName(QStringLiteral("camera_image"));
  setAccessibleName(tr("Camera picture"));
  setMinimumSize(160, 120);
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  connect(&Look::instance(), &Look::changed, this, [this] {
    refreshTint();
    update();
  });
}

int CameraImage::heightForWidth(int width) const {
  const QSize size = shown_.picture.isNull() ? kUsualPicture : shown_.picture.size();
  return width * size.height() / std::max(1, size.width());
}

void CameraImage::setPicture(const CameraPicture& picture) {
  const bool resized = shown_.picture.size() != picture.picture.size();
  shown_ = picture;
  refreshTint();
  if (resized) updateGeometry();
  update();
}

void CameraImage::showMask(bool on) {
  mask_on_ = on;
  refreshTint();
  update();
}

void CameraImage::refreshTint() {
  tint_ = {};
  if (!mask_on_ || shown_.mask.isNull()) return;
  QColor finger = theme().force;
  finger.setAlpha(110);
  QColor other = theme().muted;
  other.setAlpha(110);
  tint_ = QImage(shown_.mask.size(), QImage::Format_ARGB32_Premultiplied);
  const QRgb on = qPremultiply(finger.rgba());
  const QRgb else_dark = qPremultiply(other.rgba());
  for (int y = 0; y < tint_.height(); ++y) {
    const uchar* from = shown_.mask.constScanLine(y);
    auto* to = reinterpret_cast<QRgb*>(tint_.scanLine(y));
    for (int x = 0; x < tint_.width(); ++x) to[x] = from[x] == 255 ? on : from[x] != 0 ? else_dark : 0;
  }
}

void CameraImage::setEmptyText(const QString& text) {
  if (text == empty_text_) return;
  empty_text_ = text;
  if (shown_.picture.isNull()) update();
}

void CameraImage::setTouchable(PictureToTouchpad to_touchpad) {
  to_touchpad_ = std::move(to_touchpad);
  if (!to_touchpad_) release();
  setCursor(to_touchpad_ ? Qt::CrossCursor : Qt::ArrowCursor);
}

QRectF CameraImage::target() const {
  const QSize picture = shown_.picture.isNull() ? kUsualPicture : shown_.picture.size();
  const QSizeF fitted = QSizeF(picture).scaled(QSizeF(size()), Qt::KeepAspectRatio);
  return {QPointF((width() - fitted.width()) / 2, (height() - fitted.height()) / 2), fitted};
}

void CameraImage::paintFinger(QPainter& painter, const QRectF& area) const {
  const double s = area.width() / shown_.picture.width();
  if (!shown_.region.isEmpty()) {
    const QRectF region(area.left() + shown_.region.x() * s, area.top() + shown_.region.y() * s,
                        shown_.region.width() * s, shown_.region.height() * s);
    if (!tint_.isNull()) painter.drawImage(region, tint_);
    painter.setPen(QPen(QColor(255, 255, 255, 150), 4));  // seen on dark pictures
    painter.drawRect(region);
    painter.setPen(QPen(QColor(20, 24, 28), 1.5));  // seen on light ones
    painter.drawRect(region);
  }
  if (!shown_.finger.contact) return;
  const QPointF centre(area.left() + (shown_.finger.x_px + 0.5) * s, area.top() + (shown_.finger.y_px + 0.5) * s);
  for (const auto& [colour, width] : {std::pair{QColor(0, 0, 0, 170), 4.0}, std::pair{QColor(Qt::white), 2.0}}) {
    painter.setPen(QPen(colour, width));
    painter.drawLine(centre - QPointF(10, 0), centre + QPointF(10, 0));
    painter.drawLine(centre - QPointF(0, 10), centre + QPointF(0, 10));
  }
}

void CameraImage::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRectF area = target();
  if (shown_.picture.isNull()) {
    painter.setPen(QPen(theme().line, 1, Qt::DashLine));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    painter.setPen(theme().muted);
    painter.setFont(textFont(TextSize::small));
    constexpr int kHow = Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap;
    const QRect below = rect().adjusted(12, 52, -12, -8);
    const bool fits = painter.boundingRect(below, kHow, empty_text_).height() <= below.height();
    // Long words are worth more than the icon.
    if (fits) paintIcon(painter, QRectF(width() / 2.0 - 16, 16, 32, 32), QStringLiteral("camera"), theme().muted);
    painter.drawText(fits ? below : rect().adjusted(8, 8, -8, -4), kHow, empty_text_);
    return;
  }
  QPainterPath corners;
  corners.addRoundedRect(area, 4, 4);
  painter.setClipPath(corners);
  painter.drawImage(area, shown_.picture);
  paintFinger(painter, area);
}

void CameraImage::touch() {
  const QRectF area = target();
  if (!to_touchpad_ || area.width() <= 0 || shown_.picture.isNull()) return;
  const double s = shown_.picture.width() / area.width();
  const QPointF pad = to_touchpad_((mouse_ - area.topLeft()) * s - QPointF(0.5, 0.5));
  emit fingerMoved(pad.x(), pad.y(), depth_mm_);
}

void CameraImage::release() {
  if (!touching_) return;
  touching_ = false;
  emit fingerReleased();
}

void CameraImage::changeDepth(double by_mm) {
  depth_mm_ = std::clamp(depth_mm_ + by_mm, 0.0, kMaximumDepth_mm);
  emit depthChanged(depth_mm_);
  if (touching_) touch();
}

void CameraImage::mousePressEvent(QMouseEvent* event) {
  if (!to_touchpad_ || event->button() != Qt::LeftButton || shown_.picture.isNull()) return;
  touching_ = true;
  mouse_ = hand_ = event->position();
  touch();
}

void CameraImage::mouseMoveEvent(QMouseEvent* event) {
  if (!touching_) return;
  if (event->modifiers().testFlag(Qt::ShiftModifier)) {
    // The place stays where it is; only the depth follows the mouse.
    changeDepth((event->position().y() - hand_.y()) * kDepthPerPixel_mm);
  } else {
    mouse_ += event->position() - hand_;
    touch();
  }
  hand_ = event->position();
}

void CameraImage::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) release();
}

void CameraImage::wheelEvent(QWheelEvent* event) {
  if (!to_touchpad_) {
    event->ignore();
    return;
  }
  // A touchpad divides a notch into many small turns, and turns to the side as well.
  constexpr int kNotch = QWheelEvent::DefaultDeltasPerStep;
  const int turn = event->angleDelta().y();
  if (turn != 0) changeDepth(-kDepthStep_mm * turn / kNotch);
  event->accept();
}

void CameraImage::hideEvent(QHideEvent* event) {
  release();  // a hidden view must not keep the finger pressed
  QWidget::hideEvent(event);
}

}  // namespace fyd::widgets
