#include "core/pipeline/safety.h"

#include <gtest/gtest.h>

namespace fyd::pipeline {
namespace {

using enum SafetyState;
using Row = std::array<SafetyState, kSafetyEventCount>;

// Written out a second time, from DESIGN's sentences and not from the code, entry by entry.
TEST(SafetyTable, EveryEntryIsAsDesigned) {
  const auto row = [](SafetyState state) {
    Row out{};
    for (std::size_t e = 0; e < kSafetyEventCount; ++e) out[e] = nextState(state, static_cast<SafetyEvent>(e));
    return out;
  };
  // gone, live, missing, complete, fault, arm, stop
  EXPECT_EQ(row(disconnected),
            (Row{disconnected, connected, disconnected, disconnected, disconnected, disconnected, stopped}));
  EXPECT_EQ(row(connected), (Row{disconnected, connected, connected, ready, connected, connected, stopped}));
  EXPECT_EQ(row(ready), (Row{disconnected, ready, connected, ready, connected, active, stopped}));
  EXPECT_EQ(row(active), (Row{held, active, held, active, held, active, stopped}));
  EXPECT_EQ(row(held), (Row{held, held, held, held, held, active, stopped}));
  EXPECT_EQ(row(stopped), (Row{stopped, stopped, stopped, stopped, stopped, active, stopped}));
}

TEST(SafetyTable, OnlyAnArmLeadsIntoActive) {
  for (std::size_t s = 0; s < kSafetyStateCount; ++s) {
    for (std::size_t e = 0; e < kSafetyEventCount; ++e) {
      const auto state = static_cast<SafetyState>(s);
      const auto event = static_cast<SafetyEvent>(e);
      if (state != active && nextState(state, event) == active) {
        EXPECT_EQ(event, SafetyEvent::arm);
      }
    }
  }
}

TEST(SafetyTable, StopWinsFromEverywhere) {
  for (std::size_t s = 0; s < kSafetyStateCount; ++s) {
    EXPECT_EQ(nextState(static_cast<SafetyState>(s), SafetyEvent::stop), stopped);
  }
}

TEST(Safety, HeldRemembersTheFirstCause) {
  Safety safety;
  for (const auto event : {SafetyEvent::devices_live, SafetyEvent::inputs_complete, SafetyEvent::arm})
    safety.apply(event);
  ASSERT_EQ(safety.state(), active);
  safety.apply(SafetyEvent::fault, Lack::robot_lost);
  safety.apply(SafetyEvent::fault, Lack::ir_stale);
  EXPECT_EQ(safety.state(), held);
  EXPECT_EQ(safety.heldBecause(), Lack::robot_lost);
  safety.apply(SafetyEvent::arm);
  EXPECT_EQ(safety.heldBecause(), Lack::none);
}

TEST(Safety, EveryLackSaysWhatAndWhatToDo) {
  for (std::size_t i = 1; i < kLackCount; ++i) {
    EXPECT_FALSE(toString(static_cast<Lack>(i)).empty()) << i;
    EXPECT_FALSE(remedy(static_cast<Lack>(i)).empty()) << i;
  }
}

}  // namespace
}  // namespace fyd::pipeline
