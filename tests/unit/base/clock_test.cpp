// The clock of a session: monotonic, and held back by threads that are late. The truth is the operating system's clock.
#include "core/base/clock.h"

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace fyd {
namespace {

using std::chrono::milliseconds;
using Real = std::chrono::steady_clock;

/// Does what the machine must not stand still in between, again until it did not.
template <class Work>
void promptly(Work&& work) {
  for (int tries = 0; tries < 20; ++tries) {
    const auto began = Real::now();
    work();
    if (Real::now() - began <= milliseconds(1)) return;
  }
  FAIL() << "the machine stood still for a millisecond, 20 times within a few instructions";
}

TEST(Clock, RunsAsTheSystemsWhileNobodyHoldsIt) {
  const auto real = Real::now();
  const auto here = Clock::now();
  std::this_thread::sleep_for(milliseconds(30));
  const auto passed = Clock::now() - here;
  EXPECT_GE(passed, milliseconds(30));
  EXPECT_LE(passed, Real::now() - real);
}

TEST(Clock, DoesNotPassTheTimeThatAHoldNamed) {
  const Clock::duration before = Clock::heldBack();
  ClockHold hold(true);
  Clock::time_point latest;
  promptly([&] { hold.until(latest = Clock::now() + milliseconds(5)); });
  std::this_thread::sleep_for(milliseconds(40));
  EXPECT_EQ(Clock::now(), latest);
  EXPECT_GE(Clock::heldBack() - before, milliseconds(30));
}

TEST(Clock, GoesOnFromWhereItStoodAndNotWithAJump) {
  ClockHold hold(true);
  Clock::time_point stood;
  promptly([&] { hold.until(stood = Clock::now() + milliseconds(2)); });
  std::this_thread::sleep_for(milliseconds(50));
  const auto real = Real::now();
  hold.until(stood + std::chrono::hours(1));
  const auto after = Clock::now();
  EXPECT_GE(after, stood);
  EXPECT_LE(after - stood, Real::now() - real + milliseconds(1));
}

TEST(Clock, WhatWasHeldBackStaysSoWhenTheHoldIsGone) {
  Clock::time_point stood;
  Real::time_point real;
  {
    ClockHold hold(true);
    promptly([&] { hold.until(stood = Clock::now() + milliseconds(1)); });
    std::this_thread::sleep_for(milliseconds(50));
    real = Real::now();
  }
  const auto after = Clock::now();
  EXPECT_LE(after - stood, Real::now() - real + milliseconds(1));
}

TEST(Clock, WaitsForTheLatestOfSeveral) {
  ClockHold first(true), second(true);
  Clock::time_point now;
  promptly([&] {
    now = Clock::now();
    first.until(now + milliseconds(50));
    second.until(now + milliseconds(3));
  });
  std::this_thread::sleep_for(milliseconds(20));
  EXPECT_EQ(Clock::now(), now + milliseconds(3));
}

TEST(Clock, AHoldThatNamesNoTimeOrHoldsNothingChangesNothing) {
  ClockHold silent(true), off(false);
  off.until(Clock::now());
  const auto here = Clock::now();
  std::this_thread::sleep_for(milliseconds(10));
  EXPECT_GE(Clock::now() - here, milliseconds(10));
}

TEST(Clock, ATimeInThePastHoldsAtThePresent) {
  std::optional<ClockHold> hold;
  Clock::time_point here;
  promptly([&] {
    hold.emplace(true);
    here = Clock::now();
    hold->until(here - std::chrono::hours(1));
  });
  std::this_thread::sleep_for(milliseconds(10));
  EXPECT_GE(Clock::now(), here);
  EXPECT_LT(Clock::now(), here + milliseconds(5));
}

TEST(Clock, NeverGoesBackForAnyThreadWhileHoldsComeAndGo) {
  std::atomic<bool> end{false};
  std::atomic<std::int64_t> latest{0};
  std::atomic<int> backwards{0};
  std::vector<std::jthread> threads;
  threads.reserve(2);
  for (int i = 0; i < 2; ++i) {
    threads.emplace_back([&] {
      while (!end) {
        const std::int64_t seen = latest.load();  // was returned before this call
        const std::int64_t now = Clock::now().time_since_epoch().count();
        if (now < seen) ++backwards;
        std::int64_t known = latest.load();
        while (known < now && !latest.compare_exchange_weak(known, now)) {
        }
      }
    });
  }
  for (int i = 0; i < 2; ++i) {
    threads.emplace_back([&, i] {
      while (!end) {
        ClockHold hold(true);
        for (int k = 0; k < 20; ++k) {
          hold.until(Clock::now() + std::chrono::microseconds(100 * (i + 1)));
          std::this_thread::sleep_for(std::chrono::microseconds(150));
        }
      }
    });
  }
  std::this_thread::sleep_for(milliseconds(400));
  end = true;
  threads.clear();
  EXPECT_EQ(backwards, 0);
}

TEST(Clock, SleepsNoShorterWhileItIsHeldBack) {
  ClockHold hold(true);
  Clock::time_point due;
  promptly([&] {
    due = Clock::now() + milliseconds(10);
    hold.until(due - milliseconds(5));
  });
  const auto real = Real::now();
  std::jthread later([&] {
    std::this_thread::sleep_for(milliseconds(60));
    hold.until(due + milliseconds(100));
  });
  Clock::sleepUntil(due);
  EXPECT_GE(Clock::now(), due);
  EXPECT_GE(Real::now() - real, milliseconds(60));
}

}  // namespace
}  // namespace fyd
