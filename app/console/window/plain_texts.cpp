#include "app/console/window/plain_texts.h"

#include <QApplication>
#include <QEvent>
#include <QLabel>

namespace fyd::console {

PlainTexts::PlainTexts() { qApp->installEventFilter(this); }

// Each widget is polished once, before it is first seen. Qt's tool tip is a label too.
bool PlainTexts::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Polish) {
    if (auto* label = qobject_cast<QLabel*>(watched)) label->setTextFormat(Qt::PlainText);
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace fyd::console
