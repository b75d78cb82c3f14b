#include "app/console/shell/key_guard.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>

namespace fyd::console {

KeyGuard::KeyGuard(QObject* parent) : QObject(parent) { qApp->installEventFilter(this); }

bool KeyGuard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    // The filter sees the event for the window and for the focused widget; requesting a stop twice is harmless.
    if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) emit stopPressed();
  } else if (event->type() == QEvent::ShortcutOverride) {
    const bool control =
        qobject_cast<QAbstractButton*>(watched) != nullptr || qobject_cast<QComboBox*>(watched) != nullptr;
    if (control && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) event->accept();
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace fyd::console
