// Waits of the window's tests: the event loop runs until something has come. In vain they say the condition, and for
// WAIT_EQUAL what there was in its place.
#pragma once

#include <QTimer>
#include <QtTest>
#include <memory>

namespace fyd::tests {

/// Nothing that a test waits for takes so long on a machine that does anything else: it does not come.
inline constexpr int kPatience_ms = 60'000;

}  // namespace fyd::tests

#define WAIT_FOR(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, ::fyd::tests::kPatience_ms)
#define WAIT_EQUAL(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, ::fyd::tests::kPatience_ms)

namespace fyd::tests {

/// For what must not happen: every timer of this thread that is due within `ms` from now has acted afterwards, even
/// when the machine stood still for all of it. (A mere wait may be over before a single event was looked at.)
inline void passTimers(int ms) {
  // Where the test has failed already the wait gives up at once, and the timer comes after it.
  const auto passed = std::make_shared<bool>(false);
  QTimer::singleShot(ms, Qt::PreciseTimer, [passed] { *passed = true; });
  WAIT_FOR(*passed);
}

}  // namespace fyd::tests
