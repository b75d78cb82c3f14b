// What the mouse does in a curve: drag to pan, wheel to zoom, a box with the right button, a click for the cursor.
#include <QMouseEvent>
#include <QRubberBand>
#include <QWheelEvent>
#include <cmath>

#include "widgets/curves/curve_plot.h"
#include "widgets/curves/curve_strip.h"

namespace fyd::widgets {
namespace {

constexpr int kStill_px = 3;          // a press that never moves farther is a click
constexpr double kLeastShare = 1e-9;  // of the largest number, a stretched range at least
constexpr double kWidest = 1e12;

}  // namespace

double CurveStrip::timeAt(double x_px) const { return plot_->xAxis->pixelToCoord(x_px); }

bool CurveStrip::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton && event.button() != Qt::RightButton) return false;
  button_ = event.button();
  last_ = pressed_ = event.position();
  dragged_ = false;
  return true;
}

bool CurveStrip::move(const QMouseEvent& event) {
  // A plot hidden while the button is down never sees it released.
  if (!event.buttons().testFlag(button_)) {
    button_ = Qt::NoButton;
    band_->hide();
  }
  // The tremor of a hand that clicks would stop the curves.
  if (!dragged_ && (event.position() - pressed_).manhattanLength() <= kStill_px) return button_ != Qt::NoButton;
  dragged_ = true;
  if (button_ == Qt::LeftButton) {
    emit panned(timeAt(event.position().x()) - timeAt(last_.x()));
    last_ = event.position();
  } else if (button_ == Qt::RightButton) {
    band_->setGeometry(QRect(pressed_.toPoint(), event.position().toPoint()).normalized());
    band_->show();
  }
  return button_ != Qt::NoButton;
}

bool CurveStrip::release(const QMouseEvent& event) {
  if (button_ == Qt::NoButton || event.button() != button_) return true;  // as after a double click
  const bool box = button_ == Qt::RightButton && band_->isVisible();
  button_ = Qt::NoButton;
  band_->hide();
  const QRect rect = QRect(pressed_.toPoint(), event.position().toPoint()).normalized();
  if (event.button() == Qt::LeftButton && !dragged_)
    emit clicked(std::clamp(timeAt(event.position().x()), plot_->xAxis->range().lower, 0.0));
  if (box && rect.width() > 4 && rect.height() > 4) {
    fixRange({plot_->yAxis->pixelToCoord(rect.bottom()), plot_->yAxis->pixelToCoord(rect.top())});
    emit boxed(timeAt(rect.left()), std::min(0.0, timeAt(rect.right())));
  }
  return true;
}

void CurveStrip::wheel(const QWheelEvent& event) {
  if (event.angleDelta().y() == 0) return;  // a wheel turned sideways
  const double factor = std::pow(0.8, event.angleDelta().y() / 120.0);
  if (event.modifiers().testFlag(Qt::ControlModifier)) {
    // The axis shows the last picture; several notches may come before the next.
    const Range shown = fixed_range_.value_or(Range{plot_->yAxis->range().lower, plot_->yAxis->range().upper});
    const double share = 1.0 - (event.position().y() - plot_->axisRect()->top()) / plot_->axisRect()->height();
    const double about = shown.lower + share * (shown.upper - shown.lower);
    const Range next{about + (shown.lower - about) * factor, about + (shown.upper - about) * factor};
    const double width = next.upper - next.lower;
    const double largest = std::max(std::abs(next.lower), std::abs(next.upper));
    // Numbers at the axis must still differ.
    if (factor < 1.0 ? !(width > kLeastShare * largest) : !(width < kWidest)) return;
    fixRange(next);
    emit stretched();
  } else {
    emit zoomed(factor, std::min(0.0, timeAt(event.position().x())));
  }
}

bool CurveStrip::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress: return press(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove: return move(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease: return release(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonDblClick: emit followAsked(); return true;
    case QEvent::Wheel: wheel(*static_cast<QWheelEvent*>(event)); return true;
    default: return QWidget::eventFilter(watched, event);
  }
}

}  // namespace fyd::widgets
