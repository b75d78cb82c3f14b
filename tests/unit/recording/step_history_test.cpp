// The last seconds in memory while a recording begins with them and reads them.
#include <gtest/gtest.h>

#include "core/recording/writer/step_history.h"

namespace fyd::recording {
namespace {

TEST(StepHistoryReading, AChunkWithoutAStepIsNoStart) {
  StepHistory history;
  history.beginChunk({.state = "before", .parameters = {}});
  EXPECT_FALSE(history.start());
  std::vector<std::byte> packed(kLargestPackedStep);
  packed.resize(packStep({.inputs = {}, .outputs = {}}, packed));
  history.add(packed, instantAt(7.0));
  ASSERT_TRUE(history.start());
  EXPECT_EQ(history.start()->when, instantAt(7.0));
  EXPECT_EQ(history.start()->snapshot->state, "before");
}

TEST(StepHistoryReading, WhatIsUnreadCountsFromTheReadersPlaceInWhicheverChunk) {
  StepHistory history;
  std::vector<std::byte> packed(kLargestPackedStep);
  packed.resize(packStep({.inputs = {}, .outputs = {}}, packed));
  constexpr std::uint64_t kSteps = 2'500;
  for (std::uint64_t i = 0; i < kSteps; ++i) {
    if (history.chunkIsDue()) history.beginChunk({});
    history.add(packed, instantAt(0.001 * static_cast<double>(i)));
  }
  history.readFromStart();
  StepRecord record;
  for (std::uint64_t read = 1; read <= kSteps; ++read) {
    ASSERT_TRUE(history.read(record));
    ASSERT_EQ(history.unread(), kSteps - read);
  }
  EXPECT_FALSE(history.read(record));
}

}  // namespace
}  // namespace fyd::recording
