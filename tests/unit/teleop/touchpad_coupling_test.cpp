// Couplings of the touchpad: the stiffness target from the robot's values, energy of a touch, passivity.
#include "core/teleop/coupling/touchpad_coupling.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/not_a_number.h"

namespace fyd::teleop {
namespace {

using Choice = TouchpadCouplingChoice;
constexpr double kInf = std::numeric_limits<double>::infinity();

/// A session in which each call is a step of 1 ms, and what is told stays until it is told anew.
struct Session {
  TouchpadCoupling coupling;
  TouchpadCouplingInput next;
  TouchpadCouplingOutput out;

  explicit Session(Choice choice) {
    next.choice = choice;
    next.led = true;
  }
  void tell(double stiffness, double force_N = kNaN, const Vec3& place_mm = {}) {
    next.robot = {.stiffness_N_per_mm = stiffness, .force_N = force_N, .position_mm = place_mm};
    ++next.robot_count;
  }
  void press(double depth_mm, double force_N = 1.0) {
    next.touched = true;
    next.indentation_mm = depth_mm;
    next.force_N = force_N;
  }
  void lift() {
    next.touched = false;
    next.indentation_mm = next.force_N = 0.0;
  }
  double run(double seconds = 0.001) {
    for (auto left = std::lround(seconds * 1e3); left > 0; --left) out = coupling.step(next);
    return out.target_N_per_mm;
  }
};

TEST(TouchpadCoupling, BeforeTheRobotTellsThereIsNoTarget) {
  for (const Choice choice : {Choice::direct, Choice::spring, Choice::tdpa, Choice::model}) {
    Session session(choice);
    EXPECT_TRUE(std::isnan(session.run()));
    session.tell(0.0);  // it touches nothing
    EXPECT_EQ(session.run(), 0.0);
    session.tell(0.6);
    EXPECT_EQ(session.run(), 0.6);
    session.next.robot_count = 0;  // another session
    EXPECT_TRUE(std::isnan(session.run()));
  }
}

TEST(TouchpadCoupling, DirectIsWhatTheRobotTellsWhateverItIs) {
  Session session(Choice::direct);
  session.press(4.0);
  for (const double told : {0.6, 0.0, -1.0, 20.0, kInf}) {
    session.tell(told);
    EXPECT_EQ(session.run(), told);
  }
  session.tell(kNaN);
  EXPECT_TRUE(std::isnan(session.run()));
}

TEST(TouchpadCoupling, SpringIsTheForceOverTheIndentationWithinTheTargets) {
  Session session(Choice::spring);
  session.tell(0.6, 3.0);
  EXPECT_EQ(session.run(), 0.6);  // not touched: nothing to divide by
  session.press(0.4);
  EXPECT_EQ(session.run(), 0.6);  // too little
  session.press(5.0);
  EXPECT_NEAR(session.run(), 0.6, 1e-12);
  session.tell(0.6, 1.5);
  EXPECT_NEAR(session.run(), 0.3, 1e-12);
  session.tell(0.6, 1e6);
  EXPECT_EQ(session.run(), kMostTarget_N_per_mm);
  session.tell(0.6, 0.0);
  EXPECT_EQ(session.run(), kLeastTarget_N_per_mm);
  session.tell(0.7);  // a robot that tells no force: as direct
  EXPECT_EQ(session.run(), 0.7);
}

TEST(TouchpadCoupling, TheEnergyOfATouchIsWhatTheClothHoldsLessWhatTheMotorsPutIn) {
  Session session(Choice::tdpa);
  session.next.cloth_N_per_mm = 0.5;
  session.tell(0.5, 0.0);
  session.run();
  EXPECT_TRUE(std::isnan(session.out.finger_energy_mJ));
  for (int i = 0; i <= 100; ++i) {
    session.press(0.05 * i, 0.5 * 0.05 * i);
    session.run();
  }
  EXPECT_NEAR(session.out.finger_energy_mJ, 6.25, 1e-9);  // the triangle below 2.5 N and 5 mm
  for (int i = 1; i <= 100; ++i) {  // stiffened to 0.8 while it is pressed: 0.3 · 25 / 2 = 3.75 mJ of the motors'
    const double cloth = 0.5 + 0.003 * i;
    session.next.cloth_N_per_mm = i % 10 == 5 ? kNaN : cloth;
    session.press(i % 10 == 3 ? kNaN : 5.0, i % 10 == 7 ? kNaN : cloth * 5.0);
    session.run();
  }
  EXPECT_NEAR(session.out.finger_energy_mJ, 6.25, 0.01);  // the finger has not moved
  for (int i = 100; i >= 0; --i) {
    session.press(0.05 * i, 0.8 * 0.05 * i);
    session.run();
  }
  EXPECT_NEAR(session.out.finger_energy_mJ, -3.75, 0.01);
  session.lift();
  session.next.cloth_N_per_mm = 0.5;  // the motors are free to move now
  session.run(0.1);
  EXPECT_NEAR(session.out.finger_energy_mJ, -3.75, 0.01);  // it stays after the touch
  session.press(2.0, 1.0);
  session.run();
  EXPECT_NEAR(session.out.finger_energy_mJ, 1.0, 1e-9);  // and begins anew with the next
}

TEST(TouchpadCoupling, TdpaAsksForASofterClothWhenLessWasPutIn) {
  Session session(Choice::tdpa);
  session.tell(0.5, 2.0);
  for (int i = 0; i <= 40; ++i) {
    session.press(0.1 * i, 0.5 * 0.1 * i);
    session.run();
  }
  EXPECT_NEAR(session.run(), 0.5, 1e-9);  // 4 mm and 2 N: what the robot feels
  session.tell(0.5, 12.0);                // a blow, late: 3 N/mm, but 4 mJ were put in
  const double asked = session.run();
  EXPECT_LT(asked, 0.7);
  EXPECT_GE(0.5 * asked * 4.0 * 4.0, 4.0);
  Session spring(Choice::spring);
  spring.tell(0.5, 12.0);
  spring.press(4.0, 2.0);
  EXPECT_EQ(spring.run(), 3.0);
}

TEST(TouchpadCoupling, ModelStiffensOutOfContactAndSoftensSlowly) {
  Session session(Choice::model);
  session.tell(0.5, kNaN, {1, 2, -3});
  EXPECT_EQ(session.run(), 0.5);
  session.press(4.0);
  session.run();
  session.tell(0.8, kNaN, {1, 2, -3});
  EXPECT_EQ(session.run(2.0), 0.5);  // it rests where it was
  session.lift();
  EXPECT_EQ(session.run(), 0.8);
  session.press(4.0);
  session.run();
  session.tell(0.4, kNaN, {1, 2, -3});
  EXPECT_GT(session.run(0.05), 0.6);
  EXPECT_NEAR(session.run(0.6), 0.4, 0.005);
}

TEST(TouchpadCoupling, ModelStiffensAtAnotherPlaceAndBoundedlyFast) {
  Session session(Choice::model);
  session.tell(0.5, kNaN, {0, 0, -4});
  session.press(4.0);
  session.run(0.1);
  session.tell(0.8, kNaN, {1.5, 0, -4});
  EXPECT_EQ(session.run(1.0), 0.5);  // no other place yet
  session.tell(0.8, kNaN, {2.5, 0, -4});
  double last = 0.5;
  for (int i = 0; i < 300; ++i) {
    const double now = session.run();
    ASSERT_GE(now, last);
    ASSERT_LE(now - last, 0.0031);
    last = now;
  }
  EXPECT_NEAR(last, 0.8, 0.02);
  session.run(0.3);
  session.tell(0.8, kNaN, {2.5, 0, -4});
  session.run();
  session.tell(0.95, kNaN, {2.5, 0, -4});
  EXPECT_NEAR(session.run(1.0), 0.8, 0.01);  // there it rests again
}

TEST(TouchpadCoupling, ARobotInTheAirSaysNothingOfTheSurfaceAndOneBeyondItThatItIsGone) {
  Session session(Choice::model);
  session.tell(0.6, kNaN, {0, 0, -4});
  session.press(4.0);
  session.run();
  session.tell(0.0, kNaN, {0, 0, 5});  // the finger's first lift, late: it presses again
  EXPECT_EQ(session.run(1.0), 0.6);
  session.tell(0.0, kNaN, {0, 0, -6.5});
  EXPECT_LT(session.run(0.5), 0.06);
  session.tell(0.6, kNaN, {0, 0, -8});  // something below: not under this press
  EXPECT_LT(session.run(0.5), 0.06);
  session.lift();
  EXPECT_EQ(session.run(), 0.6);
}

TEST(TouchpadCoupling, WhileTheClothIsNotLedNothingIsWithheld) {
  Session session(Choice::model);
  session.next.led = false;
  session.tell(0.5);
  session.press(4.0);
  session.run();
  session.tell(0.8);
  EXPECT_EQ(session.run(), 0.8);
}

TEST(TouchpadCoupling, WithheldIsWhatTheAskedClothWouldHaveGivenMore) {
  Session session(Choice::model);
  session.tell(0.5);
  session.run();
  for (int i = 0; i <= 40; ++i) {
    session.press(0.1 * i);
    session.run();
  }
  EXPECT_NEAR(session.out.withheld_mJ, 0.0, 1e-12);
  session.tell(0.8);
  session.run(1.0);
  for (int i = 40; i >= 0; --i) {
    session.press(0.1 * i);
    session.run();
  }
  EXPECT_NEAR(session.out.withheld_mJ, 0.5 * (0.8 - 0.5) * 16.0, 1e-9);
}

TEST(TouchpadCoupling, WhateverComesInTheTargetIsANumberWithinTheTargets) {
  std::mt19937 random(4);
  const std::array<double, 11> values{0.0, 0.5, 1.0, -1.0, 1e-300, 1e300, kNaN, kInf, -kInf, 3.0, -0.0};
  const auto any = [&] { return values[random() % values.size()]; };
  for (const Choice choice : {Choice::spring, Choice::tdpa, Choice::model}) {
    Session session(choice);
    session.tell(0.6);
    session.run();
    for (int i = 0; i < 200'000; ++i) {
      if (random() % 3 == 0) session.tell(any(), any(), {any(), any(), any()});
      if (random() % 100 == 0) session.next.robot_count -= 1;  // an older one again
      if (session.next.robot_count == 0) session.next.robot_count = 7;
      session.next.touched = random() % 8 != 0;
      session.next.led = random() % 9 != 0;
      session.next.indentation_mm = any();
      session.next.force_N = any();
      session.next.cloth_N_per_mm = any();
      session.next.elapsed_s = any();
      session.next.least_indentation_mm = 1.0;
      const double target = session.run();
      ASSERT_TRUE(target >= kLeastTarget_N_per_mm && target <= kMostTarget_N_per_mm) << target;
      ASSERT_FALSE(std::isinf(session.out.finger_energy_mJ) || std::isinf(session.out.withheld_mJ));
    }
  }
}

}  // namespace
}  // namespace fyd::teleop
