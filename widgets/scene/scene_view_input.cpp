// Mouse and keyboard input of the scene view.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "widgets/scene/scene_view.h"

namespace fyd::widgets {
namespace {

constexpr double kTurn_deg_per_px = 0.4;
constexpr double kTurnKey_deg = 5.0;
constexpr double kMoveKey_px = 24.0;
constexpr double kZoomNotch = 1.15;
constexpr double kDriveKey_px = 4.0;
constexpr double kDriveNotch_px = 4.0;
constexpr double kGrab_px = 14.0;         // around the haptic point
constexpr double kFarthestTarget = 10.0;  // limit of the haptic point's target, in radii from the scene's middle
constexpr double kNotch_deg8 = 120.0;     // angle delta of one notch of a wheel

}  // namespace

void SceneView::cameraMoved() {
  side_.reset();
  hint_ = false;
  wake();
}

bool SceneView::onPoint(QPointF at_px) const {
  if (!state_.point_mm.finite()) return false;
  const QPointF off = camera_.project(state_.point_mm, size()) - at_px;
  return std::hypot(off.x(), off.y()) <= kGrab_px;
}

void SceneView::setDrivable(bool on, const SceneBox& reach) {
  reach_ = reach;
  if (on == drivable_) return;
  drivable_ = on;
  setMouseTracking(on);
  touch_->setVisible(on);
  if (!on) {
    touch_->setChecked(false);
    release();
    unsetCursor();
  }
}

void SceneView::beginDriving() {
  if (driven_mm_) return;
  driven_mm_ = state_.point_mm.finite() ? state_.point_mm : camera_.target_mm();
  news_ = true;
  wake();
}

void SceneView::drive(Vec3 by_mm) {
  if (!drivable_) return;
  beginDriving();
  Vec3 to_mm = *driven_mm_ + by_mm;
  if (!to_mm.finite() || (to_mm - camera_.centre_mm()).norm() > kFarthestTarget * camera_.radius_mm()) return;
  if (!reach_.empty()) {
    to_mm = {std::clamp(to_mm.x, reach_.lowest_mm.x, reach_.highest_mm.x),
             std::clamp(to_mm.y, reach_.lowest_mm.y, reach_.highest_mm.y),
             std::clamp(to_mm.z, reach_.lowest_mm.z, reach_.highest_mm.z)};
  }
  driven_mm_ = to_mm;
  news_ = true;
  wake();
  emit pointDriven(to_mm);
}

void SceneView::release() {
  if (hand_ == Hand::drives) hand_ = Hand::nothing;
  if (!driven_mm_) return;
  driven_mm_.reset();
  news_ = true;
  wake();
  emit pointReleased();
}

void SceneView::mousePressEvent(QMouseEvent* event) {
  if (hand_ != Hand::nothing) return;
  hand_px_ = event->position();
  const bool left = event->button() == Qt::LeftButton;
  if (left && drivable_ &&
      (touch_->isChecked() || event->modifiers().testFlag(Qt::ControlModifier) || onPoint(hand_px_))) {
    hand_ = Hand::drives;
    drive({});
  } else if (left) {
    hand_ = event->modifiers().testFlag(Qt::ShiftModifier) ? Hand::moves : Hand::turns;
  } else if (event->button() == Qt::MiddleButton || event->button() == Qt::RightButton) {
    hand_ = Hand::moves;
  }
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF by = event->position() - hand_px_;
  switch (hand_) {
    case Hand::nothing:
      setCursor(touch_->isChecked()                       ? Qt::CrossCursor
                : drivable_ && onPoint(event->position()) ? Qt::OpenHandCursor
                                                          : Qt::ArrowCursor);
      return;
    case Hand::turns:
      camera_.orbit(-kTurn_deg_per_px * by.x(), kTurn_deg_per_px * by.y());
      cameraMoved();
      break;
    case Hand::moves:
      camera_.pan(by);
      cameraMoved();
      break;
    case Hand::drives:
      // With Shift the mouse moves the point away from the eye or towards it.
      drive(event->modifiers().testFlag(Qt::ShiftModifier) ? (-by.y() * camera_.mmPerPixel()) * camera_.forward()
                                                           : camera_.motion(by));
      break;
  }
  hand_px_ = event->position();
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  if (hand_ == Hand::drives && event->button() != Qt::LeftButton) return;
  if (hand_ == Hand::drives) release();
  if (event->buttons() == Qt::NoButton) hand_ = Hand::nothing;
}

void SceneView::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / kNotch_deg8;
  if (hand_ == Hand::drives) {
    drive((kDriveNotch_px * notches * camera_.mmPerPixel()) * camera_.forward());
  } else {
    camera_.zoom(std::pow(kZoomNotch, notches), event->position(), size());
    cameraMoved();
  }
  event->accept();
}

/// @param only_ask only tell whether the key is used here; do nothing yet
bool SceneView::keyed(QKeyEvent* event, bool only_ask) {
  const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
  const bool control = event->modifiers().testFlag(Qt::ControlModifier);
  if (event->modifiers() & (Qt::AltModifier | Qt::MetaModifier)) return false;
  QPointF arrow;
  double away = 0.0;
  switch (event->key()) {
    case Qt::Key_Left: arrow = {-1, 0}; break;
    case Qt::Key_Right: arrow = {1, 0}; break;
    case Qt::Key_Up: arrow = {0, -1}; break;
    case Qt::Key_Down: arrow = {0, 1}; break;
    case Qt::Key_PageUp: away = 1.0; break;
    case Qt::Key_PageDown: away = -1.0; break;
    default: break;
  }
  if (control) {
    if (!drivable_ || (arrow.isNull() && away == 0.0)) return false;
    const double step_px = shift ? 1.0 : kDriveKey_px;
    if (!only_ask) {
      drive(camera_.motion(step_px * arrow) + (step_px * away * camera_.mmPerPixel()) * camera_.forward());
    }
    return true;
  }
  if (!arrow.isNull()) {
    if (only_ask) return true;
    if (shift) {
      camera_.pan(-kMoveKey_px * arrow);  // the camera moves with the arrow
    } else {
      camera_.orbit(kTurnKey_deg * arrow.x(), -kTurnKey_deg * arrow.y());
    }
    cameraMoved();
    return true;
  }
  const QPointF middle(width() / 2.0, height() / 2.0);
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
      if (only_ask) return true;
      camera_.zoom(event->key() == Qt::Key_Minus ? 1.0 / kZoomNotch : kZoomNotch, middle, size());
      cameraMoved();
      return true;
    case Qt::Key_Home:
    case Qt::Key_1:
    case Qt::Key_2:
    case Qt::Key_3: {
      if (shift) return false;
      if (only_ask) return true;
      look(event->key() == Qt::Key_Home ? SceneSide::home
           : event->key() == Qt::Key_1  ? SceneSide::front
           : event->key() == Qt::Key_2  ? SceneSide::top
                                        : SceneSide::right);
      return true;
    }
    default: return false;
  }
}

bool SceneView::event(QEvent* event) {
  // While this widget has the focus, its own keys come before the window's.
  if (event->type() == QEvent::ShortcutOverride && keyed(static_cast<QKeyEvent*>(event), true)) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  if (!keyed(event, false)) QWidget::keyPressEvent(event);
}

void SceneView::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Control && hand_ != Hand::drives) release();
  QWidget::keyReleaseEvent(event);
}

void SceneView::focusOutEvent(QFocusEvent* event) {
  release();
  update();
  QWidget::focusOutEvent(event);
}

void SceneView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::EnabledChange && !isEnabled()) release();
  QWidget::changeEvent(event);
}

}  // namespace fyd::widgets
