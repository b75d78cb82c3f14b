#include "app/console/shell/key_guard.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>

#include "widgets/basics/hold_button.h"

namespace fyd::console {

KeyGuard::KeyGuard(QObject* parent) : QObject(parent) {
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);  // only Qt's own dialogs hand their keys to us
  qApp->installEventFilter(this);
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
    // The filter sees the event for the window and for the focused widget; requesting a stop twice is harmless.
    if (key.key() == Qt::Key_Escape) emit stopPressed();
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
