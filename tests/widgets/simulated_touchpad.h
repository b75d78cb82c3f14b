// An operator's hands at a window on the simulated touchpad, in real time. A busy machine misses cycles, and then the
// station takes its hand off: whatever moves is asked for again, as an operator would.
#pragma once

#include "app/console/calibrate/calibrate_page.h"
#include "tests/widgets/scripted_session.h"

namespace fyd::tests {

inline constexpr int kAttempt_ms = 10'000;
inline constexpr int kAttempts = 20;

/// By mouse, until it acts or may not any more. @return whether it acted
inline bool pressAndHold(widgets::HoldButton* button) {
  QTest::mousePress(button, Qt::LeftButton);
  (void)QTest::qWaitFor([&] { return button->engaged() || !button->isEnabled(); }, kPatience_ms);
  return button->engaged();
}

/// The simulated points of the part that is shown; the operator's eyes see whether the fit is good.
inline void takeSimulated(console::CalibratePage* page) {
  const auto good = [page] { return page->acceptButton()->isEnabled(); };
  // A part that is measured on the simulation itself may find the finger not away yet.
  for (int attempt = 0; attempt < kAttempts && !good(); ++attempt) {
    WAIT_FOR(page->simulateButton()->isEnabled());
    QTest::mouseClick(page->simulateButton(), Qt::LeftButton);
    const auto over = [&] { return good() || page->hint().startsWith(QLatin1String("Not taken")); };
    (void)QTest::qWaitFor(over, kAttempt_ms);
  }
  QVERIFY2(good(), qPrintable(page->hint() + page->fitPanel()->verdict()));
}

/// One point of the stiffness map for real: the simulated motors go there, the simulated finger presses.
inline void measureOneStretch(console::CalibratePage* page) {
  for (int attempt = 0; attempt < kAttempts && page->points().empty(); ++attempt) {
    WAIT_FOR(page->moveButton()->isEnabled());
    (void)pressAndHold(page->moveButton());
    const auto over = [&] {
      return !page->points().empty() || page->hint().startsWith(QLatin1String("The motors are off"));
    };
    (void)QTest::qWaitFor(over, kAttempt_ms);
    QTest::mouseRelease(page->moveButton(), Qt::LeftButton);
  }
  QVERIFY2(!page->points().empty(), qPrintable(page->hint() + page->live()));
}

/// A window whose thread or station was held up says "Unknown" and refuses what needs a state, until it hears more.
inline void hearTheStation(const console::MainWindow& window) {
  WAIT_FOR(window.stateBar()->stateWord() != QLatin1String("Unknown"));
}

/// Arms until the motion goes on: from Ready, and from Held once what was missing is back.
inline void makeActive(console::MainWindow& window) {
  const widgets::StateBar* bar = window.stateBar();
  const auto active = [bar] { return bar->stateWord() == QLatin1String("Active"); };
  for (int attempt = 0; attempt < kAttempts && !active(); ++attempt) {
    WAIT_FOR(active() || bar->armButton()->isEnabled());
    if (active()) return;
    (void)pressAndHold(bar->armButton());
    (void)QTest::qWaitFor(active, kAttempt_ms);
    QTest::mouseRelease(bar->armButton(), Qt::LeftButton);
  }
  QVERIFY2(active(), qPrintable(bar->stateWord() + bar->stateReason()));
}

}  // namespace fyd::tests
