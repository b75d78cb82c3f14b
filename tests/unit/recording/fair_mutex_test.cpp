// The lock of HDF5 goes to whoever waits, and to its holder as often as that one asks.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

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
  while (turns == 0) std::this_thread::yield();
  int waited = 0;
  constexpr int kAsked = 50;
  for (int i = 0; i < kAsked; ++i) {
    const int before = turns;
    const std::lock_guard lock(mutex);
    waited += turns - before;
  }
  EXPECT_LE(waited, 4 * kAsked) << "turns of the other in " << kAsked;
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
