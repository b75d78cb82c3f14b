// The touch motion sent to the robot: relative and absolute, workspace and speed limits, non-finite inputs.
#include "core/pipeline/touch_motion.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/not_a_number.h"

namespace fyd::pipeline {
namespace {

MotionInput touching(double x_mm, double y_mm, double indentation_mm = 0.0) {
  MotionInput input;
  input.elapsed = std::chrono::milliseconds(1);
  input.enabled = true;
  input.contact = true;
  input.finger_x_mm = x_mm;
  input.finger_y_mm = y_mm;
  input.indentation_mm = indentation_mm;
  return input;
}

MotionInput lifted() {
  MotionInput input = touching(0, 0);
  input.contact = false;
  return input;
}

TouchMessage settle(TouchMotion& motion, const MotionInput& input) {
  TouchMessage message;
  for (int i = 0; i < 1000; ++i) message = motion.step(input);
  return message;
}

TEST(TouchMotion, ANewTouchDoesNotMoveTheRobot) {
  TouchMotion motion;
  EXPECT_EQ(settle(motion, touching(20, 10)).position_mm, (Vec3{0, 0, 0}));
  EXPECT_NEAR(settle(motion, touching(25, 7)).position_mm.x, 5.0, 1e-12);
  settle(motion, lifted());
  const Vec3 again = settle(motion, touching(-30, -20)).position_mm;
  EXPECT_NEAR(again.x, 5.0, 1e-12);
  EXPECT_NEAR(again.y, -3.0, 1e-12);
}

TEST(TouchMotion, AbsoluteFollowsTheFingerItself) {
  TouchMotion motion;
  MotionInput input = touching(20, 10);
  input.absolute = true;
  const Vec3 there = settle(motion, input).position_mm;
  EXPECT_NEAR(there.x, 20.0, 1e-12);
  EXPECT_NEAR(there.y, 10.0, 1e-12);
}

TEST(TouchMotion, PressingIsNegativeZAndLiftingReturnsToZero) {
  TouchMotion motion;
  EXPECT_NEAR(settle(motion, touching(0, 0, 4.0)).position_mm.z, -4.0, 1e-12);
  EXPECT_NEAR(settle(motion, touching(0, 0, -2.0)).position_mm.z, 0.0, 1e-12);
  settle(motion, touching(0, 0, 4.0));
  EXPECT_NEAR(settle(motion, lifted()).position_mm.z, 0.0, 1e-12);
}

TEST(TouchMotion, TheWorkspaceIsNeverLeftAndItsEdgeDoesNotStick) {
  TouchMotion motion;
  settle(motion, touching(0, 0));
  const Vec3 edge = settle(motion, touching(90, -90, 500)).position_mm;
  EXPECT_EQ(edge, (Vec3{35, -25, -70}));
  EXPECT_NEAR(settle(motion, touching(89, -89, 0)).position_mm.x, 34.0, 1e-12);
}

TEST(TouchMotion, TheSpeedLimitHoldsWhateverTheFingerDoes) {
  TouchMotion motion;
  (void)motion.step(touching(0, 0));
  const Vec3 next = motion.step(touching(30, 0, 8)).position_mm;
  EXPECT_NEAR(next.x, 0.2, 1e-12);
  EXPECT_NEAR(next.z, -0.2, 1e-12);
}

TEST(TouchMotion, SaysBesideThePlaceWhatThePictureShowedAndWhen) {
  TouchMotion motion;
  MotionInput input = touching(0, 0);
  input.finger_taken = instantAt(5.0);
  EXPECT_EQ(motion.step(input).seen->x_mm, 0.0);
  input.finger_x_mm = 3.0;  // of the next picture, 33 ms later: 90 mm/s
  input.finger_taken = instantAt(5.033);
  const TouchMessage moved = motion.step(input);
  EXPECT_NEAR(moved.position_mm.x, 0.2, 1e-12) << "on its way";
  EXPECT_NEAR(moved.seen->x_mm, 3.0, 1e-12);
  EXPECT_EQ(moved.seen->taken, instantAt(5.033));
  EXPECT_NEAR(settle(motion, input).seen->x_mm, 3.0, 1e-12) << "until another picture comes";
  input.finger_y_mm = 20.0;  // 606 mm/s: as far as the limit of 200 mm/s goes in 33 ms
  input.finger_taken = instantAt(5.066);
  EXPECT_NEAR(motion.step(input).seen->y_mm, 6.6, 1e-9);
  input.finger_taken = instantAt(4.0);  // older than what is known
  EXPECT_NEAR(motion.step(input).seen->y_mm, 6.6, 1e-9);
  input.contact = false;
  EXPECT_FALSE(motion.step(input).seen) << "a lifted finger is nowhere";
}

TEST(TouchMotion, DisabledStandsStill) {
  TouchMotion motion;
  settle(motion, touching(0, 0));
  const Vec3 before = settle(motion, touching(5, 5, 3)).position_mm;
  MotionInput input = touching(-20, 0, 8);
  input.enabled = false;
  EXPECT_EQ(settle(motion, input).position_mm, before);
  EXPECT_FALSE(motion.step(input).in_contact);
}

TEST(TouchMotion, WhatIsNotANumberMovesNothing) {
  TouchMotion motion;
  settle(motion, touching(0, 0, 2));
  const Vec3 before = settle(motion, touching(3, 3, 2)).position_mm;
  MotionInput bad = touching(kNaN, 3, 2);
  EXPECT_EQ(motion.step(bad).position_mm.x, before.x);
  bad = touching(3, 3, kNaN);
  bad.force_N = kNaN;
  const TouchMessage message = motion.step(bad);
  EXPECT_EQ(message.position_mm.z, before.z);
  EXPECT_EQ(message.force_N, 0.0);
  bad = touching(3, 3, 5);
  bad.elapsed = -std::chrono::seconds(1);
  EXPECT_EQ(motion.step(bad).position_mm.z, before.z);
}

}  // namespace
}  // namespace fyd::pipeline
