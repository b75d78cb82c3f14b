#include "app/console/key_guard.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>

namespace fyd::console {

KeyGuard::KeyGuard(QObject* parent) : QObject(parent) { qApp->installEventFilter(this); }

bool KeyGuard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    // The window and then the focused widget get it: a stop asked for twice is one stop.
    if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) emit stopPressed();
  } else if (event->type() == QEvent::ShortcutOverride) {
    const bool control =
        qobject_cast<QAbstractButton*>(watched) != nullptr || qobject_cast<QComboBox*>(watched) != nullptr;
    if (control && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) event->accept();
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace fyd::console
