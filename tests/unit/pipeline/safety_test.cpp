// The safety states: every entry of the transition table, and the causes of Held.
#include "core/pipeline/safety.h"

#include <gtest/gtest.h>

#include <map>

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
  safety.apply(SafetyEvent::fault, Fault::robot_lost);
  safety.apply(SafetyEvent::fault, Fault::ir_stale);
  EXPECT_EQ(safety.state(), held);
  EXPECT_EQ(safety.heldBecause(), Fault::robot_lost);
  safety.apply(SafetyEvent::arm);
  EXPECT_EQ(safety.heldBecause(), Fault::none);
}

TEST(Safety, EveryFaultSaysWhatAndWhatToDo) {
  for (const FaultInfo& info : faultsByUrgency()) {
    const auto number = static_cast<int>(info.fault);
    EXPECT_NE(info.fault, Fault::none);
    EXPECT_LT(static_cast<std::size_t>(number), kFaultCount);
    EXPECT_FALSE(info.what.empty() || info.what.ends_with('.')) << number;
    EXPECT_TRUE(info.remedy.ends_with('.')) << number;
    EXPECT_EQ(info.part == Part::none, info.need == Need::rendering)
        << number << ": what is needed has a line to be in";
    EXPECT_EQ(toString(info.fault), info.what);
  }
  EXPECT_EQ(toString(static_cast<Fault>(200)), "a reason that this program does not know");
  EXPECT_EQ(toString(Fault::none), "nothing missing");
}

TEST(Safety, EveryStateHasItsNameAndANumberOfNoneSaysSo) {
  constexpr std::array<std::string_view, kSafetyStateCount> kNames{"Disconnected", "Connected", "Ready",
                                                                   "Active",       "Held",      "Stopped"};
  for (std::size_t i = 0; i < kSafetyStateCount; ++i) EXPECT_EQ(toString(static_cast<SafetyState>(i)), kNames[i]);
  EXPECT_EQ(toString(static_cast<SafetyState>(kSafetyStateCount)), "an unknown state");
}

TEST(Safety, TheNumbersOfFaultsInFilesStay) {
  // As written by the program that gave them numbers; a new one is added here and never changed.
  const std::map<int, std::string_view> words{
      {1, "the haptic loop stood still for more than 20 ms"},
      {2, "more than 5 % of the haptic cycles of one second were missed"},
      {3, "the motors are silent"},
      {4, "the distance sensors are silent"},
      {5, "too few distance sensors read within their span"},
      {6, "the load cell is silent"},
      {7, "the load cell's value is outside its span"},
      {8, "the camera sends no pictures"},
      {9, "the camera sees nothing: picture black, white, of one grey, empty or in an unknown light"},
      {10, "no robot has connected"},
      {11, "the robot is silent"},
      {12, "the robot has said goodbye"},
      {13, "the robot's stiffness is not a number"},
      {14, "no stiffness target"},
      {15, "the window did not answer for half a second"}};
  for (const auto& [number, what] : words) EXPECT_EQ(toString(static_cast<Fault>(number)), what);
}

}  // namespace
}  // namespace fyd::pipeline
