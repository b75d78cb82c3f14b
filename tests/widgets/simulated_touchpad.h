// An operator's hands at a window on the simulated touchpad, in real time. A busy machine misses cycles, and then the
// station takes its hand off: whatever moves is asked for again, as an operator would.
#pragma once

#include "app/console/calibrate_page.h"
#include "tests/widgets/scripted_session.h"

namespace fyd::tests {

inline constexpr int kPatience_ms = 30000;
inline constexpr int kAttempt_ms = 10000;
inline constexpr int kAttempts = 5;

/// By mouse, until it acts or may not any more. @return whether it acted
inline bool pressAndHold(widgets::HoldButton* button) {
  QTest::mousePress(button, Qt::LeftButton);
  (void)QTest::qWaitFor([&] { return button->engaged() || !button->isEnabled(); });
  return button->engaged();
}

/// The simulated points of the part that is shown; the operator's eyes see whether the fit is good.
inline void takeSimulated(console::CalibratePage* page) {
  const auto good = [page] { return page->acceptButton()->isEnabled(); };
  // A part that is measured on the simulation itself may find the finger not away yet.
  for (int attempt = 0; attempt < kAttempts && !good(); ++attempt) {
    QTRY_VERIFY_WITH_TIMEOUT(page->simulateButton()->isEnabled(), kPatience_ms);
    QTest::mouseClick(page->simulateButton(), Qt::LeftButton);
    const auto over = [&] { return good() || page->hint().startsWith(QLatin1String("Not taken")); };
    (void)QTest::qWaitFor(over, kAttempt_ms);
  }
  QVERIFY2(good(), qPrintable(page->hint() + page->fitPanel()->verdict()));
}

/// One point of the stiffness map for real: the simulated motors go there, the simulated finger presses.
inline void measureOneStretch(console::CalibratePage* page) {
  for (int attempt = 0; attempt < kAttempts && page->points().empty(); ++attempt) {
    QTRY_VERIFY_WITH_TIMEOUT(page->moveButton()->isEnabled(), kPatience_ms);
    (void)pressAndHold(page->moveButton());
    const auto over = [&] {
      return !page->points().empty() || page->hint().startsWith(QLatin1String("The motors are off"));
    };
    (void)QTest::qWaitFor(over, kAttempt_ms);
    QTest::mouseRelease(page->moveButton(), Qt::LeftButton);
  }
  QVERIFY2(!page->points().empty(), qPrintable(page->hint() + page->live()));
}

/// Arms until the motion goes on: from Ready, and from Held once what was missing is back.
inline void makeActive(console::MainWindow& window) {
  const widgets::StateBar* bar = window.stateBar();
  const auto active = [bar] { return bar->stateWord() == QLatin1String("Active"); };
  for (int attempt = 0; attempt < kAttempts && !active(); ++attempt) {
    QTRY_VERIFY_WITH_TIMEOUT(active() || bar->armButton()->isEnabled(), kPatience_ms);
    if (active()) return;
    (void)pressAndHold(bar->armButton());
    (void)QTest::qWaitFor(active);
    QTest::mouseRelease(bar->armButton(), Qt::LeftButton);
  }
  QVERIFY2(active(), qPrintable(bar->stateWord() + bar->stateReason()));
}

}  // namespace fyd::tests
