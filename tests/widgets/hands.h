// What several of the window's tests do with a window, and how they look at it and at its files.
#pragma once

#include "tests/widgets/scripted_session.h"

namespace fyd::tests {

/// As an operator can: only what is there.
inline void click(QWidget* widget) {
  QVERIFY(widget != nullptr && widget->isVisible() && widget->isEnabled());
  QTest::mouseClick(widget, Qt::LeftButton);
}

inline console::DevicesPage* devicesOf(const Fixture& f) {
  return qobject_cast<console::DevicesPage*>(f.window->frame()->page(QStringLiteral("devices")));
}

/// Empty: no such file.
inline QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace fyd::tests
