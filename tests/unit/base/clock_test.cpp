// The clock of a session: monotonic, and held back by threads that are late. The truth is the operating system's clock.
#include "core/base/clock.h"

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace fyd {
namespace {

using std::chrono::milliseconds;
using Real = std::chrono::steady_clock;

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
  const auto latest = Clock::now() + milliseconds(5);
  hold.until(latest);
  std::this_thread::sleep_for(milliseconds(40));
  EXPECT_EQ(Clock::now(), latest);
  EXPECT_GE(Clock::heldBack() - before, milliseconds(30));
}

TEST(Clock, GoesOnFromWhereItStoodAndNotWithAJump) {
  ClockHold hold(true);
  const auto stood = Clock::now() + milliseconds(2);
  hold.until(stood);
  std::this_thread::sleep_for(milliseconds(50));
  const auto real = Real::now();
  hold.until(stood + std::chrono::hours(1));
  const auto after = Clock::now();
  EXPECT_GE(after, stood);
  EXPECT_LE(after - stood, Real::now() - real + milliseconds(1));
}

TEST(Clock, WhatWasHeldBackStaysSoWhenTheHoldIsGone) {
  Clock::time_point stood;
  {
    ClockHold hold(true);
    stood = Clock::now() + milliseconds(1);
    hold.until(stood);
    std::this_thread::sleep_for(milliseconds(50));
  }
  const auto real = Real::now();
  EXPECT_LE(Clock::now() - stood, Real::now() - real + milliseconds(5));
}

TEST(Clock, WaitsForTheLatestOfSeveral) {
  ClockHold first(true), second(true);
  const auto now = Clock::now();
  first.until(now + milliseconds(50));
  second.until(now + milliseconds(3));
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
  ClockHold hold(true);
  const auto here = Clock::now();
  hold.until(here - std::chrono::hours(1));
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
  const auto due = Clock::now() + milliseconds(10);
  hold.until(due - milliseconds(5));
  std::jthread later([&] {
    std::this_thread::sleep_for(milliseconds(60));
    hold.until(due + milliseconds(100));
  });
  const auto real = Real::now();
  Clock::sleepUntil(due);
  EXPECT_GE(Clock::now(), due);
  EXPECT_GE(Real::now() - real, milliseconds(60));
}

}  // namespace
}  // namespace fyd
