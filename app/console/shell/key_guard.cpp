#include "app/console/shell/key_guard.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QWindow>

#include "widgets/basics/hold_button.h"

namespace fyd::console {

bool Application::notify(QObject* receiver, QEvent* event) {
  if (event->type() == QEvent::KeyPress || event->type() == QEvent::MouseButtonPress) emit pressed(receiver, event);
  return QApplication::notify(receiver, event);
}

KeyGuard::KeyGuard(QObject* parent) : QObject(parent) {
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);  // only Qt's own dialogs hand their keys to us
  auto* application = qobject_cast<Application*>(qApp);
  if (application == nullptr) qFatal("Esc is heard in an Application only");
  connect(application, &Application::pressed, this, &KeyGuard::hear);
  application->installEventFilter(this);
}

void KeyGuard::hear(QObject* receiver, QEvent* event) {
  // Heard for the window and for the focused widget; requesting a stop twice is harmless.
  if (event->type() == QEvent::KeyPress) {
    if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) emit stopPressed();
  } else if (pressesStop(receiver, *static_cast<QMouseEvent*>(event))) {
    emit stopPressed();
  }
}

/// A press comes to a window first; in a drag that holds the mouse, to the picture that is dragged, which nothing else
/// could press.
bool KeyGuard::pressesStop(const QObject* receiver, const QMouseEvent& press) const {
  const auto* window = qobject_cast<const QWindow*>(receiver);
  if (window == nullptr || stop_button_ == nullptr || !stop_button_->isVisible()) return false;
  const bool hears =
      window == stop_button_->window()->windowHandle() || (window->flags() & Qt::WindowTransparentForInput);
  return hears && press.button() == Qt::LeftButton &&
         stop_button_->rect().contains(stop_button_->mapFromGlobal(press.globalPosition().toPoint()));
}

/// X11 repeats a key that is held as pairs of a release and a press, which Qt cannot always tell from real ones: the
/// server gives such a pair one time, and no finger can.
bool KeyGuard::isRepeat(const QKeyEvent& press) const {
  return press.key() == Qt::Key_Space && !press.isAutoRepeat() && press.timestamp() != 0 &&
         press.timestamp() == space_released_;
}

bool KeyGuard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const auto& key = *static_cast<QKeyEvent*>(event);
    // The key that armed is still down, and the focus has come to STOP. A button that is held for a while is let go by the
    // release of such a pair and held anew by its press: that errs to the safe side.
    if (isRepeat(key) && qobject_cast<widgets::HoldButton*>(QApplication::focusWidget()) == nullptr) return true;
  } else if (event->type() == QEvent::KeyRelease) {
    const auto& key = *static_cast<QKeyEvent*>(event);
    if (key.key() == Qt::Key_Space && !key.isAutoRepeat()) space_released_ = key.timestamp();
  } else if (event->type() == QEvent::ShortcutOverride) {
    // Ctrl+U is the window's own where it has a use; QLineEdit would empty itself.
    if (qobject_cast<QLineEdit*>(watched) != nullptr &&
        static_cast<QKeyEvent*>(event)->matches(QKeySequence::DeleteCompleteLine)) {
      event->ignore();
      return true;
    }
    const bool control =
        qobject_cast<QAbstractButton*>(watched) != nullptr || qobject_cast<QComboBox*>(watched) != nullptr;
    if (control && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) event->accept();
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace fyd::console
