// The step allocates nothing after its construction: counted at operator new.
#include <gtest/gtest.h>

#include "app/bench/parts/allocation_count.h"
#include "core/pipeline/pipeline.h"

namespace fyd::pipeline {
namespace {

TEST(StepAllocation, TheCounterSeesAnAllocation) {
  const bench::AllocationCount counted;
  ::operator delete(::operator new(16));  // a plain `delete new int` may be optimised away
  EXPECT_GE(counted.count(), 1U);
}

TEST(StepAllocation, NoStepAllocatesWhateverItIsAskedTo) {
  Pipeline pipeline{Parameters{}};
  std::uint64_t steps_with_events = 0;
  const bench::AllocationCount counted;
  for (int i = 0; i < 20'000; ++i) {
    Inputs inputs;
    inputs.now = instantAt(5.0 + i * 0.001);
    sensing::FingerDetection finger;
    finger.contact = (i / 2000) % 2 == 1;
    finger.reason = finger.contact ? sensing::FingerReason::found : sensing::FingerReason::no_finger;
    finger.x_mm = 0.001 * i;
    inputs.finger.set(finger, inputs.now);
    inputs.finger.count = static_cast<std::uint64_t>(i) / 33 + 1;
    sensing::IrCounts ir;
    for (int sensor = 0; sensor < 3; ++sensor) (void)ir.push(static_cast<std::uint16_t>(1200 + i % 7));
    inputs.ir.set(ir, inputs.now);
    inputs.ir.count = static_cast<std::uint64_t>(i) / 16 + 1;
    inputs.bridge.set({.value_mV_per_V = 0.4}, inputs.now);
    inputs.motors.set({.encoder_counts = {228, 3868}}, inputs.now);
    inputs.robot.phase = LinkPhase::running;
    inputs.robot.state.set({.stiffness_N_per_mm = 0.6}, inputs.now);
    (void)inputs.robot.accelerations.push({.taken = inputs.now, .acceleration_g = {0.1, -0.2, 0.3 * (i % 5)}});
    if (i % 1000 == 10)
      (void)inputs.commands.push({.action = static_cast<OperatorAction>((i / 1000) % 5), .value = 0.6});
    if (i % 500 == 20) (void)inputs.robot.commands.push(static_cast<RobotCommand>((i / 500) % 12));
    if (i % 100 == 30) (void)inputs.changes.push({.index = static_cast<std::uint16_t>((i / 100) % 130), .value = 1.0});
    if (!pipeline.step(inputs).events.empty()) ++steps_with_events;
  }
  EXPECT_EQ(counted.count(), 0U);
  EXPECT_GT(steps_with_events, 50U);
}

}  // namespace
}  // namespace fyd::pipeline
