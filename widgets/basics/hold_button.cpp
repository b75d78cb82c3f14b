#include "widgets/basics/hold_button.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "widgets/basics/theme.h"

namespace fyd::widgets {
namespace {

bool isPressKey(const QKeyEvent& event) {
  return event.key() == Qt::Key_Space || event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

}  // namespace

HoldButton::HoldButton(const QString& text, QWidget* parent) : QPushButton(text, parent) {
  setAutoDefault(false);
  timer_.setInterval(16);
  connect(&timer_, &QTimer::timeout, this, &HoldButton::tick);
  connect(this, &QPushButton::pressed, this, &HoldButton::begin);
  connect(this, &QPushButton::released, this, &HoldButton::cancel);
}

double HoldButton::progress() const { return holding_ ? std::min(1.0, static_cast<double>(held_ms_) / kHold_ms) : 0.0; }

void HoldButton::begin() {
  if (!fresh_ || !isEnabled()) return;
  fresh_ = false;
  holding_ = true;
  held_ms_ = 0;
  since_tick_.start();
  timer_.start();
}

void HoldButton::cancel() {
  if (holding_) {
    holding_ = false;
    timer_.stop();
    update();
  }
  if (engaged_) {
    engaged_ = false;
    emit letGo();
  }
}

void HoldButton::stop() {
  fresh_ = false;
  cancel();
}

void HoldButton::tick() {
  // After a stall Qt runs this before it delivers the letting go that waits, so what passed unheard does not count. And
  // the whole hold acts only at the next tick: whatever had come until then has been heard in between.
  const bool whole = held_ms_ >= kHold_ms;
  held_ms_ += std::min<qint64>(since_tick_.restart(), kLongestStep_ms);
  if (whole) {
    holding_ = false;
    timer_.stop();
    engaged_ = true;
    emit held();
  }
  update();
}

bool HoldButton::event(QEvent* event) {
  // The window's one-key shortcuts must not take the space bar away from a focused button.
  if (event->type() == QEvent::ShortcutOverride && isPressKey(*static_cast<QKeyEvent*>(event))) event->accept();
  return QPushButton::event(event);
}

void HoldButton::keyPressEvent(QKeyEvent* event) {
  if (!isPressKey(*event)) {
    if (event->key() == Qt::Key_Escape) stop();
    QPushButton::keyPressEvent(event);
    return;
  }
  if (!event->isAutoRepeat()) {
    fresh_ = true;
    begin();
  }
  event->accept();
}

void HoldButton::keyReleaseEvent(QKeyEvent* event) {
  if (!isPressKey(*event)) {
    QPushButton::keyReleaseEvent(event);
    return;
  }
  if (!event->isAutoRepeat()) cancel();
  event->accept();
}

void HoldButton::focusOutEvent(QFocusEvent* event) {
  cancel();
  QPushButton::focusOutEvent(event);
}

void HoldButton::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) fresh_ = true;
  QPushButton::mousePressEvent(event);
}

void HoldButton::mouseMoveEvent(QMouseEvent* event) {
  QPushButton::mouseMoveEvent(event);
  if (!hitButton(event->position().toPoint())) cancel();
}

void HoldButton::changeEvent(QEvent* event) {
  if (event->type() == QEvent::EnabledChange && !isEnabled()) cancel();
  QPushButton::changeEvent(event);
}

void HoldButton::hideEvent(QHideEvent* event) {
  cancel();
  QPushButton::hideEvent(event);
}

void HoldButton::paintEvent(QPaintEvent* event) {
  QPushButton::paintEvent(event);
  if (!holding_) return;
  QPainter painter(this);
  QColor fill = theme().live;
  painter.fillRect(QRectF(2, height() - 6, (width() - 4) * progress(), 4), fill);
  fill.setAlphaF(0.2F);
  painter.fillRect(QRectF(2, 2, (width() - 4) * progress(), height() - 8), fill);
}

}  // namespace fyd::widgets
