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

/// Changes the devices once they may be changed: a session that is silent is not left, and between a test's words the
/// machine may stand still for longer than one may be silent.
inline void changeDevices(const Fixture& f, const console::ConnectionWords& wanted) {
  const std::size_t before = f.session->asked.size();
  const auto begun = [&] {
    if (f.session->asked.size() > before) return true;
    if (!f.window->connection().work().isEmpty()) return false;
    f.session->say(pipeline::SafetyState::ready);
    f.window->feed().pump();
    f.window->connection().change(wanted);
    return false;
  };
  WAIT_FOR(begun());
  WAIT_FOR(f.window->connection().work().isEmpty());
}

/// Empty: no such file.
inline QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace fyd::tests
