// A finger (mass, damper, spring) on a cloth that follows its target late, and a robot behind a bad network. The
// energy is the test's own: the cloth's true force along the finger's true way.
#include "core/teleop/coupling/touchpad_coupling.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace fyd::teleop {
namespace {

using Choice = TouchpadCouplingChoice;
constexpr double kStep_s = 0.001;

struct Scene {
  Choice choice = Choice::model;
  double delay_s = 0.0;   // one way
  double jitter_s = 0.0;  // up to so much more
  double loss = 0.0;
  unsigned seed = 1;
  double seconds = 6.0;
  bool silent_in_air = false;  // the robot tells a stiffness only while it touches; else that of its last place
  double noise = 0.0;          // of the estimate, as a part of it
  std::function<double(double)> depth_mm;  // where the hand wants the finger to be
  std::function<double(double)> force_over_stiffness_mm = [](double) { return 0.0; };  // along the cloth
  std::function<double(double, double)> wall;  // N/mm by time and place; 0: nothing there
};

struct Row {
  double t_s, touched_s, depth_mm, speed_mm_s, cloth_N_per_mm, target_N_per_mm, energy_mJ, seen_energy_mJ;
};

std::vector<Row> play(const Scene& scene) {
  std::mt19937 random(scene.seed);
  const auto uniform = [&random] { return std::uniform_real_distribution<double>(0.0, 1.0)(random); };
  std::normal_distribution<double> normal;
  struct UnderWay {
    double due_s;
    int number;
    RobotTold told;
  };
  std::vector<UnderWay> network;
  std::deque<std::array<double, 3>> past;  // what the robot hears late: depth, way
  TouchpadCoupling coupling;
  TouchpadCouplingInput input;
  input.choice = scene.choice;
  input.led = true;
  constexpr double kMass_kg = 0.15, kHand_N_per_mm = 0.6, kDamping_N_s_per_mm = 0.004;
  double depth_mm = -2.0, speed_mm_s = 0.0, cloth = 0.5, energy_mJ = 0.0;
  int heard = -1, sent = 0;
  bool touching = false;
  double since_s = 0.0;
  std::deque<bool> seen;  // by the camera, 50 ms late
  std::vector<Row> rows;
  const auto late = static_cast<std::size_t>(std::lround(scene.delay_s / kStep_s));
  for (int i = 0; i * kStep_s < scene.seconds; ++i) {
    const double t = i * kStep_s, force_over_stiffness_mm = scene.force_over_stiffness_mm(t);
    // The robot, each 10 ms: the tool is where the finger was.
    past.push_back({depth_mm, force_over_stiffness_mm});
    if (past.size() > late + 1) past.pop_front();
    if (i % 10 == 0) {
      const double tool_mm = past.front()[0], place_mm = past.front()[1];
      const double wall = scene.wall(t, place_mm);
      const bool meets = tool_mm > 0.0 && wall > 0.0;
      const double said =
          meets || (!scene.silent_in_air && wall > 0.0) ? wall * (1.0 + scene.noise * normal(random)) : 0.0;
      const RobotTold told{.stiffness_N_per_mm = said,
                           .force_N = meets ? wall * tool_mm : 0.0,
                           .position_mm = {place_mm, 0.0, -tool_mm}};
      if (uniform() >= scene.loss) network.push_back({t + scene.delay_s + scene.jitter_s * uniform(), sent, told});
      ++sent;
    }
    for (const UnderWay& each : network) {
      if (each.due_s > t || each.number <= heard) continue;  // an older one is refused by the protocol
      heard = each.number;
      input.robot = each.told;
      ++input.robot_count;
    }
    std::erase_if(network, [t](const UnderWay& each) { return each.due_s <= t; });
    // The touchpad's sensors, each 10 ms.
    seen.push_back(depth_mm > 0.0);
    if (seen.size() > 50) seen.pop_front();
    if (i % 10 == 0) {
      input.touched = seen.front();
      input.indentation_mm = std::max(0.0, depth_mm + 0.02 * normal(random));
      input.force_N = cloth * std::max(0.0, depth_mm) + 0.005 * normal(random);
      input.cloth_N_per_mm = 1.1 * cloth;  // the law is 10 % off
    }
    const TouchpadCouplingOutput out = coupling.step(input);
    // The cloth follows in 50 ms, and can do more than the real one.
    if (out.target_N_per_mm > 0.0) cloth += (std::clamp(out.target_N_per_mm, 0.05, 3.0) - cloth) * kStep_s / 0.05;
    const double force_N = depth_mm > 0.0 ? cloth * depth_mm : 0.0;
    const double wanted_mm = scene.depth_mm(t), wanted_mm_s = (scene.depth_mm(t + kStep_s) - wanted_mm) / kStep_s;
    const double push_N = kHand_N_per_mm * (wanted_mm - depth_mm) + kDamping_N_s_per_mm * (wanted_mm_s - speed_mm_s);
    speed_mm_s += 1e3 * (push_N - force_N) / kMass_kg * kStep_s;
    const double before_mm = std::max(0.0, depth_mm);
    depth_mm += speed_mm_s * kStep_s;
    const double after_mm = std::max(0.0, depth_mm);
    if (depth_mm > 0.0 && !touching) {
      energy_mJ = 0.0;
      since_s = t;
    }
    touching = depth_mm > 0.0;
    energy_mJ += 0.5 * cloth * (before_mm + after_mm) * (after_mm - before_mm);
    rows.push_back({t, t - since_s, depth_mm, speed_mm_s, cloth, out.target_N_per_mm, energy_mJ, out.finger_energy_mJ});
  }
  return rows;
}

double leastEnergy(const std::vector<Row>& rows) { return std::ranges::min(rows, {}, &Row::energy_mJ).energy_mJ; }

/// Up to `to` at `from_s`, back at `until_s`, each within 0.2 s.
double pressed(double t, double from_s, double until_s, double to_mm) {
  return -3.0 + (to_mm + 3.0) * std::clamp(std::min((t - from_s) / 0.2, (until_s - t) / 0.2 + 1.0), 0.0, 1.0);
}
double twice(double t) { return std::max(pressed(t, 1.0, 3.0, 12.0), pressed(t, 4.0, 5.5, 12.0)); }

/// 0 to 700 ms, with jitter and loss.
std::vector<Scene> networks(Choice choice) {
  std::vector<Scene> out;
  unsigned seed = 0;
  for (const double delay_s : {0.0, 0.02, 0.05, 0.1, 0.2, 0.4, 0.7}) {
    for (const double jitter_s : {0.0, 0.05}) {
      for (const double loss : {0.0, 0.2}) {
        out.push_back({.choice = choice, .delay_s = delay_s, .jitter_s = jitter_s, .loss = loss, .seed = ++seed});
        out.back().depth_mm = twice;
      }
    }
  }
  return out;
}

TEST(TouchpadCouplingInNumbers, OnAWallThatStiffensUnderTheFingerModelGivesNothingBackAndDirectDoes) {
  for (Scene scene : networks(Choice::model)) {
    scene.wall = [](double t, double) { return t < 2.0 ? 0.4 : 1.6; };
    const auto rows = play(scene);
    EXPECT_GE(leastEnergy(rows), -0.05) << scene.delay_s;
    EXPECT_NEAR(rows.back().target_N_per_mm, 1.6, 1e-9) << scene.delay_s;  // felt with the second press
    scene.choice = Choice::direct;
    if (scene.delay_s >= 0.5) continue;
    EXPECT_LT(leastEnergy(play(scene)), -5.0) << scene.delay_s;  // the check can fail
  }
}

TEST(TouchpadCouplingInNumbers, WhatTheFingerIsToldItPutInIsWhatItPutIn) {
  for (const Choice choice : {Choice::direct, Choice::model}) {
    for (Scene scene : networks(choice)) {
      scene.wall = [](double t, double) { return t < 2.0 ? 1.2 : 0.5; };
      const auto rows = play(scene);
      double most = 0.0;
      for (const auto& row : rows) {
        most = std::max(most, row.energy_mJ);
        // The camera is late, and so are the sensors of a finger that moves.
        if (std::abs(row.speed_mm_s) > 0.5 || row.depth_mm < 1.0 || row.touched_s < 0.2) continue;
        ASSERT_NEAR(row.seen_energy_mJ, row.energy_mJ, 0.05 * most + 0.2) << row.t_s;
      }
      EXPECT_GT(most, 5.0);
    }
  }
}

TEST(TouchpadCouplingInNumbers, AWallThatSoftensIsFeltWithinHalfASecondAndTheTwoWays) {
  for (Scene scene : networks(Choice::model)) {
    scene.wall = [](double t, double) { return t < 1.8 ? 1.2 : 0.5; };
    const auto rows = play(scene);
    EXPECT_GE(leastEnergy(rows), -0.05);
    const double until_s = 1.8 + scene.delay_s + scene.jitter_s + 0.5;
    const auto at = std::ranges::find_if(rows, [&](const Row& row) { return row.t_s >= until_s; });
    if (until_s < 2.9) {
      EXPECT_NEAR(at->cloth_N_per_mm, 0.5, 0.05) << scene.delay_s << ' ' << scene.loss;
    }
  }
}

TEST(TouchpadCouplingInNumbers, AWallThatVanishesLetsTheFingerSinkWithoutGivingBack) {
  for (Scene scene : networks(Choice::model)) {
    scene.silent_in_air = true;
    scene.seconds = 8.0;
    scene.wall = [](double t, double) { return t < 4.6 ? 0.8 : 0.0; };
    scene.depth_mm = [](double t) { return std::max(pressed(t, 0.5, 2.5, 12.0), pressed(t, 4.0, 7.5, 12.0)); };
    const auto rows = play(scene);
    for (const Row& row : rows) {
      if (row.t_s > 4.2) {  // the first touch is that of a robot of which nothing was known
        ASSERT_GE(row.energy_mJ, -0.05) << scene.delay_s;
      }
    }
    const auto at = std::ranges::find_if(rows, [&](const Row& row) { return row.t_s >= 7.3; });
    EXPECT_LT(at->target_N_per_mm, 0.1) << scene.delay_s;
  }
}

TEST(TouchpadCouplingInNumbers, ARobotThatSaysNothingInTheAirIsFeltFromTheFirstMomentOfTheSecondPress) {
  for (Scene scene : networks(Choice::model)) {
    scene.silent_in_air = true;
    scene.seconds = 8.0;
    scene.depth_mm = [](double t) { return std::max(pressed(t, 0.5, 2.5, 12.0), pressed(t, 5.0, 7.5, 12.0)); };
    scene.wall = [](double, double) { return 1.2; };
    for (const Row& row : play(scene)) {
      if (row.t_s > 5.0 && row.depth_mm > 0.0) {
        ASSERT_NEAR(row.cloth_N_per_mm, 1.2, 0.02) << scene.delay_s;
      }
    }
  }
}

TEST(TouchpadCouplingInNumbers, ASlideOntoStifferGroundIsFeltWithinATimeThatIsStated) {
  for (Scene scene : networks(Choice::model)) {
    constexpr double kSpeed_mm_s = 40.0, kEdge_s = 1.5;
    scene.depth_mm = [](double t) { return pressed(t, 0.5, 5.0, 12.0); };
    scene.force_over_stiffness_mm = [](double t) { return kSpeed_mm_s * (std::clamp(t, 1.0, 2.5) - kEdge_s); };
    scene.wall = [](double, double place_mm) { return place_mm < 0.0 ? 0.5 : 1.2; };
    const auto rows = play(scene);
    // There and back, a message, the way to another place, three time constants, and three of the cloth's.
    const double until_s = kEdge_s + 2.0 * scene.delay_s + scene.jitter_s + 0.05 +
                           TouchpadCoupling::kOnePlace_mm / kSpeed_mm_s + 0.3 + 0.15;
    const auto at = std::ranges::find_if(rows, [&](const Row& row) { return row.t_s >= until_s; });
    EXPECT_GT(at->cloth_N_per_mm, 0.5 + 0.9 * (1.2 - 0.5)) << scene.delay_s << ' ' << scene.loss;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      if (rows[i].t_s > 1.0 && rows[i].t_s < 4.5) {
        ASSERT_LE(rows[i].target_N_per_mm - rows[i - 1].target_N_per_mm, 0.0071);
      }
    }
  }
}

TEST(TouchpadCouplingInNumbers, TdpaGivesBackNoMoreThanItsToleranceWhereTheSpringDoes) {
  double spring_least = 0.0;
  for (Scene scene : networks(Choice::tdpa)) {
    scene.wall = [](double, double) { return 1.0; };
    // A finger that goes in and out: the force comes when it is no longer that deep.
    scene.depth_mm = [](double t) {
      return t < 1.0 ? -3.0 : 5.0 - 8.0 * std::cos(2.0 * 3.14159265358979 * 0.9 * (t - 1.0));
    };
    double put_in_mJ = 0.0;
    const auto rows = play(scene);
    for (const Row& row : rows) put_in_mJ = std::max(put_in_mJ, row.energy_mJ);
    EXPECT_GE(leastEnergy(rows), -(TouchpadCoupling::kTolerance * put_in_mJ + 0.3)) << scene.delay_s;
    scene.choice = Choice::spring;
    spring_least = std::min(spring_least, leastEnergy(play(scene)));
  }
  EXPECT_LT(spring_least, -5.0);
}

TEST(TouchpadCouplingInNumbers, AnEstimateThatShakesIsFeltALittleSoft) {
  Scene scene{.seconds = 20.0, .noise = 0.02};
  scene.depth_mm = [](double t) { return pressed(t, 0.5, 19.0, 12.0); };
  scene.wall = [](double, double) { return 0.6; };
  for (const Row& row : play(scene)) {
    if (row.t_s > 1.0 && row.t_s < 18.5) {
      ASSERT_GT(row.target_N_per_mm, 0.93 * 0.6) << row.t_s;
      ASSERT_LT(row.target_N_per_mm, 1.06 * 0.6);
    }
  }
}

}  // namespace
}  // namespace fyd::teleop
