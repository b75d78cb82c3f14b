// The simulated robot arm: contact force, workspace and speed limits, accelerometer.
#include "core/sim/robot/robot_arm.h"

#include <gtest/gtest.h>

namespace fyd::sim {
namespace {

using namespace std::chrono_literals;

SimParameters on(Material material) {
  SimParameters parameters;
  parameters.material = material;
  return parameters;
}

struct Driven {
  explicit Driven(const SimParameters& parameters) : arm(parameters) { hold({}, 1); }

  device::RobotReadings hold(const Vec3& target_mm, int ms) {
    device::RobotReadings readings;
    for (int i = 0; i < ms; ++i) readings = arm.exchange(target_mm, now += 1ms).value();
    return readings;
  }
  /// RMS about gravity of each axis while the arm goes on to a target.
  Vec3 rms(const Vec3& target_mm, int ms) {
    Vec3 squares;
    for (int i = 0; i < ms; ++i) {
      const Vec3 a = arm.exchange(target_mm, now += 1ms).value().acceleration_g;
      squares = squares + Vec3{a.x * a.x, a.y * a.y, (a.z - 1.0) * (a.z - 1.0)};
    }
    return {std::sqrt(squares.x / ms), std::sqrt(squares.y / ms), std::sqrt(squares.z / ms)};
  }

  RobotArm arm;
  Instant now = instantAt(1.0);
};

TEST(RobotArm, ForceIsThatOfImpedanceAndMaterialInSeries) {
  for (const auto& [material, k] : {std::pair{Material::sponge, 0.32},
                                    {Material::foam, 0.50},
                                    {Material::rubber, 0.62},
                                    {Material::leather, 0.71},
                                    {Material::wood, 20.0}}) {
    Driven robot(on(material));
    EXPECT_EQ(robot.arm.trueStiffness_N_per_mm(), k);
    const auto pressed = robot.hold({0, 0, -8.0}, 1500);  // 6 mm below the surface, 1 N/mm
    EXPECT_NEAR(pressed.force_N, 6.0 * k / (1.0 + k), 1e-3);
    EXPECT_NEAR(pressed.force_N / (-2.0 - pressed.position_mm.z), k, 1e-3 * k) << "what a probe measures";
  }
}

TEST(RobotArm, AStiffnessSetByHandReplacesTheMaterialsOwn) {
  SimParameters parameters = on(Material::foam);
  parameters.material_stiffness_N_per_mm = 0.66;
  EXPECT_EQ(RobotArm(parameters).trueStiffness_N_per_mm(), 0.66);
}

TEST(RobotArm, AboveTheSurfaceAndWithoutMaterialThereIsNoForce) {
  Driven above(on(Material::wood));
  EXPECT_EQ(above.hold({5, 5, -1.9}, 1000).force_N, 0.0);
  Driven nothing(on(Material::none));
  const auto deep = nothing.hold({0, 0, -60}, 2000);
  EXPECT_EQ(deep.force_N, 0.0);
  EXPECT_NEAR(deep.position_mm.z, -60.0, 1e-3) << "it goes down unhindered: a probe must stop by itself";
}

TEST(RobotArm, LettingGoIsNeverSticky) {
  Driven robot(on(Material::sponge));
  robot.hold({0, 0, -10}, 1000);
  for (int i = 0; i < 1000; ++i) {
    const auto readings = robot.hold({0, 0, 5}, 1);
    ASSERT_GE(readings.force_N, 0.0);
    if (readings.position_mm.z > -2.0) {
      ASSERT_EQ(readings.force_N, 0.0);
    }
  }
}

TEST(RobotArm, KeepsItsWorkspaceAndSpeedWhateverTheTarget) {
  Driven robot(on(Material::rubber));
  Vec3 last;
  for (const Vec3 target : {Vec3{1e300, -1e300, 1e300}, Vec3{-1e300, 1e300, -1e300}, Vec3{100, 100, -3}}) {
    for (int i = 0; i < 1500; ++i) {
      const auto readings = robot.hold(target, 1);
      const Vec3 p = readings.position_mm;
      ASSERT_TRUE(p.finite() && readings.acceleration_g.finite() && std::isfinite(readings.force_N));
      ASSERT_LE(std::abs(p.x), 35.0);
      ASSERT_LE(std::abs(p.y), 25.0);
      ASSERT_LE(std::abs(p.z), 70.0);
      ASSERT_LE(std::hypot(p.x - last.x, p.y - last.y), 0.25 + 1e-9) << "250 mm/s";
      ASSERT_LE(std::abs(readings.acceleration_g.z), 5.0);
      last = p;
    }
  }
  EXPECT_NEAR(last.x, 35.0, 1e-6);
}

TEST(RobotArm, ATargetThatIsNoNumberIsRefusedAndTheLastOneKept) {
  Driven robot(on(Material::rubber));
  robot.hold({10, 0, 0}, 500);
  const auto refused = robot.arm.exchange({0, std::nan(""), 0}, robot.now + 1ms);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text(), "robot target (0, nan, 0) mm: expected three finite numbers");
  EXPECT_FALSE(robot.arm.exchange({INFINITY, 0, 0}, robot.now + 2ms));
  EXPECT_NEAR(robot.hold({10, 0, 0}, 10).position_mm.x, 10.0, 0.01);
}

TEST(RobotArm, AtRestTheAccelerometerSaysGravityAndItsNoise) {
  SimParameters parameters = on(Material::wood);
  parameters.accelerometer_noise_g = 0.0;
  Driven robot(parameters);
  EXPECT_EQ(robot.hold({}, 10).acceleration_g, (Vec3{0, 0, 1}));
  robot.hold({0, 0, -10}, 2000);
  const Vec3 pressed = robot.rms({0, 0, -10}, 100);
  EXPECT_LT(pressed.x, 1e-6) << "pressing without motion is silent";
  const Vec3 in_air = Driven(parameters).rms({30, 0, 0}, 300);
  EXPECT_EQ(in_air, (Vec3{0, 0, 0})) << "so is motion without touch";
}

TEST(RobotArm, StrokingShakesMoreWithSpeedForceAndRoughness) {
  const auto stroke = [](Material material, double speed_limit, double depth_mm) {
    SimParameters parameters = on(material);
    parameters.accelerometer_noise_g = 0.0;
    parameters.robot_speed_limit_mm_s = speed_limit;
    Driven robot(parameters);
    robot.hold({-35, 0, 0}, 5000);
    robot.hold({-35, 0, -2.0 - depth_mm}, 2000);
    robot.hold({35, 0, -2.0 - depth_mm}, 100);
    const Vec3 rms = robot.rms({35, 0, -2.0 - depth_mm}, 250);
    return std::hypot(rms.x, rms.y, rms.z);
  };
  const double usual = stroke(Material::leather, 60, 4);
  EXPECT_GT(usual, 0.05);
  EXPECT_LT(usual, 2.0);
  EXPECT_GT(usual, 1.3 * stroke(Material::leather, 15, 4));
  EXPECT_GT(usual, 1.3 * stroke(Material::leather, 60, 1));
  EXPECT_GT(stroke(Material::wood, 60, 4), 1.3 * usual);
  EXPECT_LT(stroke(Material::foam, 60, 4), usual);
}

TEST(RobotArm, TimeThatStandsStillGoesBackOrJumpsIsHarmless) {
  Driven robot(on(Material::rubber));
  const Vec3 before = robot.hold({20, 0, 0}, 100).position_mm;
  EXPECT_EQ(robot.arm.exchange({20, 0, 0}, robot.now)->position_mm, before);
  EXPECT_EQ(robot.arm.exchange({20, 0, 0}, robot.now - 1h)->position_mm, before);
  EXPECT_EQ(robot.arm.exchange({20, 0, 0}, robot.now - 1h)->taken, robot.now);
  const auto jumped = robot.arm.exchange({-30, 0, 0}, robot.now + 24h);
  EXPECT_GT(jumped->position_mm.x, before.x - 25.0) << "no more than 100 ms of motion";
}

TEST(RobotArm, IsTheSameForTheSameSeed) {
  const auto run = [](int seed) {
    SimParameters parameters = on(Material::leather);
    parameters.seed = seed;
    Driven robot(parameters);
    Vec3 sum;
    for (int i = 0; i < 500; ++i) sum = sum + robot.hold({0.05 * i, 0, -5}, 1).acceleration_g;
    return sum;
  };
  EXPECT_EQ(run(3), run(3));
  EXPECT_NE(run(3), run(4));
}

}  // namespace
}  // namespace fyd::sim
