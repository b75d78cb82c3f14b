// The lock of HDF5 goes to whoever waits, and to its holder as often as that one asks.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>
#include <vector>

#include "core/recording/file/recording_hdf5.h"

namespace fyd::recording {
namespace {

TEST(FairMutex, GoesToWhoWaitsThoughItsHolderTakesItAgainAtOnce) {
  FairMutex mutex;
  std::atomic<int> turns{0};
  const std::jthread busy([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      const std::lock_guard lock(mutex);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));  // as a block that is read
      ++turns;
    }
  });
  std::vector<int> waited(50);
  for (int& each : waited) {
    // Asked while the other has it: who has just let go of it would be given it by any mutex.
    const int had = turns;
    while (turns == had) std::this_thread::yield();
    const int before = turns;
    const std::lock_guard lock(mutex);
    each = turns - before;
  }
  // The machine may stop this thread between its look and its question for many turns, but not half of the times.
  std::ranges::sort(waited);
  EXPECT_LE(waited[waited.size() / 2], 1) << "turns of the other; at most " << waited.back();
}

TEST(FairMutex, IsItsHoldersAsOftenAsItAsks) {
  FairMutex mutex;
  std::atomic<bool> taken{false};
  std::jthread other;
  {
    const std::lock_guard first(mutex);
    const std::lock_guard second(mutex);
    other = std::jthread([&] {
      const std::lock_guard lock(mutex);
      taken = true;
    });
    { const std::lock_guard third(mutex); }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_FALSE(taken);
  }
  other.join();
  EXPECT_TRUE(taken);
}

}  // namespace
}  // namespace fyd::recording
