// The simulated touchpad: cloth law, motors, sensors, sampling rates and delays.
#include "core/sim/touchpad/touchpad_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/sensing/membrane.h"
#include "core/sim/touchpad/ir_sensor.h"
#include "core/sim/touchpad/simulated_touchpad.h"
#include "tests/sweep.h"

namespace fyd::sim {
namespace {

using namespace std::chrono_literals;

const Instant kStart = instantAt(100.0);

SimParameters noiseless() {
  SimParameters parameters;
  parameters.cloth = ClothKind::ideal;
  parameters.ir_noise_mV = 0.0;
  parameters.bridge_noise_mV_per_V = 0.0;
  return parameters;
}

control::MotorCommand stretchTo(double angle_deg, double vibration_percent = 0.0) {
  const auto ticks = static_cast<std::int16_t>(std::lround(angle_deg * 4200.0 / 90.0));
  return {.reference_ticks = {ticks, static_cast<std::int16_t>(-ticks)},
          .vibration_duty_percent = {vibration_percent, vibration_percent},
          .active = true};
}

/// Advances in millisecond calls, so that no jump is cut.
void runMs(TouchpadWorld& world, Instant& now, int ms) {
  for (int i = 0; i < ms; ++i) world.advanceTo(now += 1ms);
}

TEST(IdealCloth, PassesThroughTheFourMeasuredPointsAndRisesBetweenAndBeyond) {
  EXPECT_DOUBLE_EQ(nominalStiffness(20), 0.501);
  EXPECT_DOUBLE_EQ(nominalStiffness(45), 0.550);
  EXPECT_DOUBLE_EQ(nominalStiffness(60), 0.673);
  EXPECT_DOUBLE_EQ(nominalStiffness(90), 0.715);
  EXPECT_NEAR(nominalStiffness(0), 0.501 - 20 * 0.049 / 25, 1e-12);
  EXPECT_NEAR(nominalStiffness(120), 0.757, 1e-12);
  for (const double angle : stepsBefore(0.0, 120.0, 0.01)) {
    ASSERT_GT(nominalStiffness(angle + 0.01), nominalStiffness(angle)) << angle;
    ASSERT_NEAR(nominalAngle(nominalStiffness(angle)), angle, 1e-9);
  }
}

TEST(IdealCloth, BeyondItsEndsAndForNaNGivesItsEndsAndItsRest) {
  EXPECT_EQ(nominalStiffness(-1e300), nominalStiffness(0));
  EXPECT_EQ(nominalStiffness(INFINITY), nominalStiffness(120));
  EXPECT_EQ(nominalStiffness(NAN), 0.501);
  EXPECT_EQ(nominalAngle(0.0), 0.0);
  EXPECT_EQ(nominalAngle(9.0), 120.0);
  EXPECT_EQ(nominalAngle(NAN), 20.0);
}

TEST(IdealCloth, HysteresisOpensALoopAroundTheMeanLine) {
  IdealCloth cloth(1.2, 0.1);
  for (const double depth : stepsTo(0.0, 4.0, 0.1)) (void)cloth.press(20.0, 4.0 < depth ? 4.0 : depth);
  EXPECT_NEAR(cloth.press(20.0, 4.0), 1.2 * 0.501 * 4.0 * 1.1, 1e-9);
  EXPECT_NEAR(cloth.press(20.0, 3.7), 1.2 * 0.501 * 3.7, 1e-9) << "0.3 mm back: on the mean line";
  EXPECT_NEAR(cloth.press(20.0, 3.0), 1.2 * 0.501 * 3.0 * 0.9, 1e-9);
  EXPECT_EQ(cloth.press(20.0, 0.0), 0.0);
  EXPECT_EQ(cloth.press(20.0, NAN), 0.0);
  EXPECT_EQ(cloth.press(20.0, -1.0), 0.0);
  EXPECT_DOUBLE_EQ(cloth.stiffness(20.0), 1.2 * 0.501) << "the truth has no hysteresis";
}

TEST(Motor, ReachesItsReferenceAtTheSpeedLimitAndNoFaster) {
  SimulatedMotor motor(20.0);
  const MotorLimits limits;
  double fastest = 0.0;
  int ms = 0;
  for (; ms < 2000 && std::abs(motor.angle_deg() - 90.0) > 0.5; ++ms) {
    motor.step(90.0, 0.0, true, limits, 0.001);
    fastest = std::max(fastest, motor.speed_deg_s());
    ASSERT_LE(std::abs(motor.current_mA()), limits.current_mA);
  }
  EXPECT_EQ(fastest, 180.0);
  EXPECT_GT(ms, 388) << "70° at 180°/s";
  EXPECT_LT(ms, 500);
  for (int i = 0; i < 500; ++i) motor.step(90.0, 0.0, true, limits, 0.001);
  EXPECT_EQ(motor.speed_deg_s(), 0.0);
  EXPECT_NEAR(motor.angle_deg(), 90.0, 0.12 + 1e-9) << "3 % friction over 25 %/°";
}

TEST(Motor, FrictionHoldsItBelowItsShareOfDuty) {
  SimulatedMotor motor(0.0);
  const MotorLimits limits{.friction_percent = 20.0};
  for (int i = 0; i < 1000; ++i) motor.step(0.7, 0.0, true, limits, 0.001);  // 0.7° · 25 %/° = 17.5 %
  EXPECT_EQ(motor.angle_deg(), 0.0);
  for (int i = 0; i < 1000; ++i) motor.step(0.9, 0.0, true, limits, 0.001);
  EXPECT_GT(motor.angle_deg(), 0.05);
}

TEST(Motor, VibrationShakesItAboutItsReferenceAndSharesTheDuty) {
  SimulatedMotor motor(30.0);
  double low = 30.0;
  double high = 30.0;
  for (int i = 0; i < 1000; ++i) {
    motor.step(30.0, 60.0 * std::sin(2.0 * M_PI * 100.0 * i / 1000.0), true, {}, 0.001);
    if (i < 200) continue;
    low = std::min(low, motor.angle_deg());
    high = std::max(high, motor.angle_deg());
  }
  EXPECT_GT(high - low, 0.02);
  EXPECT_LT(high - low, 0.5);
  EXPECT_NEAR(0.5 * (low + high), 30.0, 0.2);
}

TEST(Motor, WithoutCurrentItStopsAndStays) {
  SimulatedMotor motor(0.0);
  for (int i = 0; i < 100; ++i) motor.step(90.0, 0.0, true, {}, 0.001);
  for (int i = 0; i < 100; ++i) motor.step(90.0, 100.0, false, {}, 0.001);
  const double held = motor.angle_deg();
  for (int i = 0; i < 100; ++i) motor.step(-90.0, 100.0, false, {}, 0.001);
  EXPECT_EQ(motor.angle_deg(), held);
  EXPECT_EQ(motor.current_mA(), 0.0);
}

TEST(Motor, NaNAndHugeCommandsStayWithinTheStops) {
  SimulatedMotor motor(20.0);
  for (const double bad : {double(NAN), double(INFINITY), -1e300, 1e300, 5e-324}) {
    for (int i = 0; i < 2000; ++i) motor.step(bad, bad, true, {}, 0.001);
    ASSERT_LE(std::abs(motor.angle_deg()), 120.0) << bad;
    ASSERT_TRUE(std::isfinite(motor.speed_deg_s()));
  }
}

TEST(IrSensor, InvertsTheThesisCurve) {
  // by hand: d(1.0 V) = 10·(−4.6327 + 39.954 − 133.8297 + 220.8604 − 188.5623 + 79.0712) = 128.609 mm
  EXPECT_NEAR(irVolts(128.609), 1.0, 1e-9);
  // d(2 V) = 10·(−148.2464 + 639.264 − 1070.6376 + 883.4416 − 377.1246 + 79.0712) = 57.682 mm
  EXPECT_NEAR(irVolts(57.682), 2.0, 1e-9);
  EXPECT_EQ(irVolts(5000.0), irVolts(790.8));
  EXPECT_EQ(irCode(3.3), 4095);
  EXPECT_EQ(irCode(1.65), 2048);
  EXPECT_EQ(irCode(-1.0), 0);
  EXPECT_EQ(irCode(NAN), 0);
  EXPECT_EQ(irVolts(NAN), 0.0);
}

TEST(TouchpadWorld, PressedInTheMiddleTheSensorsSayWhatTheModelSays) {
  TouchpadWorld world(noiseless(), FingerPath::constant(0.0, 0.0, 5.0), kStart);
  Instant now = kStart;
  runMs(world, now, 100);
  const auto readings = world.readings();
  const sensing::Membrane membrane;
  ASSERT_EQ(readings.ir.value.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const double v = 3.3 * readings.ir.value[i] / 4096.0;
    const double d = 10.0 * (-4.6327 * std::pow(v, 5) + 39.954 * std::pow(v, 4) - 133.8297 * std::pow(v, 3) +
                             220.8604 * v * v - 188.5623 * v + 79.0712);
    EXPECT_NEAR(d, 100.0 - 5.0 * membrane.shape(kIrPlaces[i].x_mm, kIrPlaces[i].y_mm, 0.0, 0.0), 0.04)
        << "half a count";
  }
  EXPECT_LT(membrane.shape(22.0, -3.0, 0.0, 0.0), 0.6) << "a membrane, not a plane";
  const double newton = (1004.8805 * readings.bridge.value.value_mV_per_V - 20.2512) / 1000.0 * 9.80665;
  EXPECT_NEAR(newton, 0.501 * 5.0, 1e-9);
  EXPECT_EQ(readings.motors.value.encoder_counts[0], 228);         // 20° · 4096/360 = 227.6
  EXPECT_EQ(readings.motors.value.encoder_counts[1], 4096 - 228);  // the other one turned the other way
  const WorldSnapshot truth = world.truth();
  EXPECT_DOUBLE_EQ(truth.force_N, 2.505);
  EXPECT_DOUBLE_EQ(truth.stiffness_N_per_mm, 0.501);
  EXPECT_DOUBLE_EQ(truth.finger.indentation_mm, 5.0);
}

TEST(TouchpadWorld, EachSensorKeepsItsOwnRateAndTime) {
  TouchpadWorld world(noiseless(), FingerPath::demonstration(), kStart);
  Instant now = kStart;
  const auto first = world.readings();
  EXPECT_EQ(first.ir.count, 1U) << "there is a reading from the start";
  EXPECT_EQ(first.ir.taken, kStart);
  Instant ir_before = first.ir.taken;
  for (int i = 0; i < 10'000; ++i) {
    world.advanceTo(now += 1ms);
    const auto readings = world.readings();
    ASSERT_LE(readings.ir.taken, now);
    if (readings.ir.taken != ir_before) {
      ASSERT_GE(readings.ir.taken - ir_before, 16ms);
      ASSERT_LE(readings.ir.taken - ir_before, 17ms);
      ir_before = readings.ir.taken;
    }
    ASSERT_EQ(readings.motors.taken, now);
  }
  EXPECT_NEAR(static_cast<double>(world.readings().ir.count), 10'000 / 16.5, 2.0);
  EXPECT_LE(world.readings().bridge.count, 1221U) << "122 samples a second and no more";
  EXPECT_GE(world.readings().bridge.count, 1219U);
}

TEST(TouchpadWorld, MotorsStretchTheClothAndTheForceFollows) {
  TouchpadWorld world(noiseless(), FingerPath::constant(0.0, 0.0, 6.0), kStart);
  Instant now = kStart;
  world.command(stretchTo(90.0));
  runMs(world, now, 300);
  EXPECT_LT(world.truth().angle_deg, 20.0 + 0.3 * 180.0) << "speed limit";
  runMs(world, now, 700);
  EXPECT_NEAR(world.truth().stiffness_N_per_mm, 0.715, 0.001);
  EXPECT_NEAR(world.truth().force_N, 6.0 * 0.715, 0.006);
  control::MotorCommand sideways{.reference_ticks = {467, 467}, .active = true};
  world.command(sideways);
  runMs(world, now, 1000);
  EXPECT_NEAR(world.truth().angle_deg, 0.0, 0.2) << "the same sense does not stretch";
}

TEST(TouchpadWorld, TrueValuesCanBeAskedForAPastInstant) {
  TouchpadWorld world(noiseless(), FingerPath::demonstration(), kStart);
  const FingerPath path = FingerPath::demonstration();
  Instant now = kStart;
  runMs(world, now, 6500);  // in the stroke from left to right
  for (const Duration back : {0us, 400us, 33'333us, 500'000us}) {
    const WorldSnapshot past = world.truthAt(now - back);
    EXPECT_NEAR(past.finger.x_mm, path.at(toSeconds(now - back - kStart)).x_mm, 1e-4);
    EXPECT_EQ(past.taken, now - back);
  }
  EXPECT_EQ(world.truthAt(now + 1s).taken, now);
  EXPECT_EQ(world.truthAt(kStart).taken, now - TouchpadWorld::kHistory + 1ms) << "no further back than it remembers";
}

TEST(TouchpadWorld, DelaysMakeReadingsShowAnOlderWorld) {
  SimParameters parameters = noiseless();
  parameters.bridge_delay_ms = 100.0;
  parameters.ir_delay_ms = 50.0;
  parameters.encoder_delay_ms = 30.0;
  TouchpadWorld world(parameters, FingerPath::constant(0.0, 0.0, 5.0), kStart);
  Instant now = kStart;
  runMs(world, now, 300);
  const auto pressed = world.readings();
  world.setFingerOverride(FingerState{});
  const Instant lifted = now;
  Instant force_gone{};
  Instant distance_back{};
  for (int i = 0; i < 300; ++i) {
    world.advanceTo(now += 1ms);
    const auto readings = world.readings();
    if (force_gone == Instant{} && readings.bridge.value.value_mV_per_V < 0.1) force_gone = now;
    if (distance_back == Instant{} && readings.ir.value[0] < pressed.ir.value[0]) distance_back = now;
  }
  EXPECT_GE(force_gone - lifted, 100ms);
  EXPECT_LE(force_gone - lifted, 110ms);
  EXPECT_GE(distance_back - lifted, 50ms);
  EXPECT_LE(distance_back - lifted, 68ms);
}

TEST(TouchpadWorld, AMouseMovesTheFingerUntilItLetsGo) {
  TouchpadWorld world(noiseless(), FingerPath::constant(10.0, 0.0, 2.0), kStart);
  Instant now = kStart;
  world.setFingerOverride(FingerState{.x_mm = -20.0, .y_mm = 99.0, .indentation_mm = 3.0, .lifted = false});
  runMs(world, now, 5);
  EXPECT_EQ(world.truth().finger.x_mm, -20.0);
  EXPECT_EQ(world.truth().finger.y_mm, 30.0);
  world.setFingerOverride(FingerState{.x_mm = NAN, .y_mm = 0.0, .indentation_mm = 3.0, .lifted = false});
  runMs(world, now, 5);
  EXPECT_TRUE(world.truth().finger.lifted);
  EXPECT_EQ(world.truth().force_N, 0.0);
  world.setFingerOverride(std::nullopt);
  runMs(world, now, 5);
  EXPECT_EQ(world.truth().finger.x_mm, 10.0);
}

TEST(TouchpadWorld, SpreadNoiseAndOffsetShowInTheReadings) {
  SimParameters parameters;
  parameters.cloth = ClothKind::ideal;
  parameters.cloth_stiffness_scale = 0.7;
  parameters.bridge_offset_mV_per_V = 0.05;
  TouchpadWorld world(parameters, FingerPath::constant(0.0, 0.0, 5.0), kStart);
  Instant now = kStart;
  double sum = 0.0;
  double squares = 0.0;
  double bridge = 0.0;
  constexpr int kSamples = 500;
  for (int i = 0; i < kSamples; ++i) {
    runMs(world, now, 17);
    const double mV = 3300.0 * world.readings().ir.value[1] / 4096.0;
    sum += mV;
    squares += mV * mV;
    bridge += world.readings().bridge.value.value_mV_per_V;
  }
  const double mean = sum / kSamples;
  EXPECT_NEAR(std::sqrt(squares / kSamples - mean * mean), 10.0, 1.0);
  const double newton = (1004.8805 * (bridge / kSamples - 0.05) - 20.2512) / 1000.0 * 9.80665;
  EXPECT_NEAR(newton, 0.7 * 0.501 * 5.0, 0.001);
}

TEST(SimulatedTouchpad, ReadsUnderTheOldCommandAndThenTakesTheNewOne) {
  auto world = std::make_shared<TouchpadWorld>(noiseless(), FingerPath::demonstration(), kStart);
  SimulatedTouchpad touchpad(world);
  EXPECT_EQ(touchpad.description().text(), "simulated touchpad, seed 1");
  ASSERT_TRUE(touchpad.exchange(stretchTo(60.0), kStart + 100ms));
  EXPECT_EQ(world->truth().angle_deg, 20.0) << "motors were not active before";
  const auto readings = touchpad.exchange(stretchTo(60.0), kStart + 200ms);
  ASSERT_TRUE(readings);
  EXPECT_GT(world->truth().angle_deg, 30.0);
  EXPECT_EQ(readings->motors.taken, kStart + 200ms);
  EXPECT_FALSE(readings->motors.value.position_duty_known) << "as the thesis' board";
}

TEST(TouchpadWorld, AnotherPathBeginsWhenItIsGivenAndTheMouseStillComesFirst) {
  TouchpadWorld world(SimParameters{}, FingerPath::constant(1.0, 2.0, 3.0), instantAt(10.0));
  world.advanceTo(instantAt(10.1));
  EXPECT_EQ(world.truth().finger.x_mm, 1.0);
  world.setPath(FingerPath::fromKnots({{0.0, {.x_mm = -20.0, .indentation_mm = 2.0, .lifted = false}},
                                       {0.2, {.x_mm = 20.0, .indentation_mm = 2.0, .lifted = false}}}));
  world.advanceTo(instantAt(10.2));
  EXPECT_NEAR(world.truth().finger.x_mm, 0.0, 1e-6);  // half of it, 0.1 s after it was given
  world.setFingerOverride(FingerState{.x_mm = 7.0, .y_mm = 0.0, .indentation_mm = 1.0, .lifted = false});
  world.advanceTo(instantAt(10.25));
  EXPECT_EQ(world.truth().finger.x_mm, 7.0);
  world.setFingerOverride(std::nullopt);
  world.advanceTo(instantAt(10.3));
  EXPECT_NEAR(world.truth().finger.x_mm, 20.0, 1e-6);
}

}  // namespace
}  // namespace fyd::sim
