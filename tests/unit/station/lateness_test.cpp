// How late the computer was in the last second, from steps whose times the test makes.
#include "core/station/lateness.h"

#include <gtest/gtest.h>

namespace fyd::station {
namespace {

TEST(Lateness, OfALoopOnTimeIsNotWorthNaming) {
  LatenessMeter meter;
  for (int ms = 0; ms < 5000; ++ms) meter.add(instantAt(ms / 1e3), 0);
  EXPECT_EQ(meter.lastSecond().missed_percent, 0.0);
  EXPECT_NEAR(meter.lastSecond().longest_gap_ms, 1.0, 1e-6);
  EXPECT_FALSE(meter.lastSecond().worthNaming());
  EXPECT_TRUE(describe(meter.lastSecond()).empty());
}

TEST(Lateness, IsThatOfTheLastSecondAndNotOfTheSession) {
  LatenessMeter meter;
  int ms = 0;
  for (; ms < 100'000; ++ms) meter.add(instantAt(ms / 1e3), 0);
  ms += 72;  // cycles 100 000 to 100 071 are missed
  for (int i = 0; i < 500; ++i, ++ms) meter.add(instantAt(ms / 1e3), 72);
  const Lateness late = meter.lastSecond();
  EXPECT_NEAR(late.missed_percent, 7.2, 0.01);
  EXPECT_NEAR(late.longest_gap_ms, 73.0, 1e-6);
  EXPECT_NE(describe(late).text().find("7.2 %"), std::string::npos);
  for (int i = 0; i < 1000; ++i, ++ms) meter.add(instantAt(ms / 1e3), 72);
  EXPECT_FALSE(meter.lastSecond().worthNaming());
}

TEST(Lateness, BeforeTheSecondStepIsNone) {
  LatenessMeter meter;
  EXPECT_FALSE(meter.lastSecond().worthNaming());
  meter.add(instantAt(7.0), 3);
  EXPECT_FALSE(meter.lastSecond().worthNaming());
}

TEST(Lateness, IsNeverBlamedForWhatATimelyComputerMayMiss) {
  using enum pipeline::Fault;
  for (const auto fault : {none, ir_invalid, bridge_invalid, camera_blind, robot_closed, robot_waiting, no_target})
    EXPECT_FALSE(mayBeLateness(fault)) << toString(fault);
  for (const auto fault : {step_gap, steps_missed, motors_stale, ir_stale, bridge_stale, camera_stale, robot_lost})
    EXPECT_TRUE(mayBeLateness(fault)) << toString(fault);
}

}  // namespace
}  // namespace fyd::station
