// Indentation, tare and stiffness in ordinary use. Truth comes from app/bench/parts/pressed_cloth.h.
#include <array>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "app/bench/parts/pressed_cloth.h"
#include "core/sensing/indentation.h"
#include "core/sensing/stiffness_estimator.h"
#include "core/sensing/tare.h"

namespace fyd::sensing {
namespace {

using bench::PressedCloth;
using bench::PressedClothOptions;

Timed<IrCounts> codesFor(std::array<double, 3> distances_mm, double at_s, std::uint64_t count = 1) {
  const IrDistance curve;
  IrCounts counts;
  for (const double d : distances_mm) {
    (void)counts.push(static_cast<std::uint16_t>(std::lround(curve.voltsAt(d) / 3.3 * 4096)));
  }
  return {.value = counts, .taken = instantAt(at_s), .count = count};
}

Timed<FingerDetection> fingerAt(double x_mm, double y_mm, double at_s, bool contact = true) {
  FingerDetection seen;
  seen.contact = contact;
  seen.x_mm = x_mm;
  seen.y_mm = y_mm;
  return {.value = seen, .taken = instantAt(at_s), .count = 1};
}

IndentationEstimate pressed(double indentation_mm, double sigma_mm = 0.2) {
  IndentationEstimate e;
  e.indentation_mm = indentation_mm;
  e.sigma_mm = sigma_mm;
  e.available = true;
  e.touched = true;
  e.reason = IndentationReason::measured;
  return e;
}

/// For presses made with the membrane's own formula: what is left is the filter.
IndentationParameters membraneMode() {
  IndentationParameters p;
  p.mode = IndentationMode::membrane;
  return p;
}

TEST(ThesisIndentation, IsThePrintedPlaneAtTheFirstReading) {
  IndentationParameters p;
  p.mode = IndentationMode::thesis;
  IndentationEstimator estimator(p);
  // z = (−4, −1, −3); at (11, 9): −1.8 − 0.1 − 1.35 + 1 − 0.75 + 0.6 − 0.3 + 0.45 = −2.25
  const IndentationEstimate e = estimator.step(instantAt(1), codesFor({96, 99, 97}, 1), fingerAt(11, 9, 1));
  EXPECT_TRUE(e.available);
  EXPECT_NEAR(e.indentation_mm, 2.25, 0.06);  // codes are whole numbers
  EXPECT_EQ(e.reason, IndentationReason::measured);
}

TEST(ThesisIndentation, SmoothsAndGates) {
  ThesisSmoother smoother;
  EXPECT_EQ(smoother.update(1.0), 1.0);
  EXPECT_NEAR(smoother.update(2.0), 1.2, 1e-12);  // 0.8·1 + 0.2·2
  EXPECT_NEAR(smoother.update(3.2), 1.2, 1e-12);  // moved 2.0: not accepted
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(smoother.update(6.0), 1.2, 1e-12);
  EXPECT_NEAR(smoother.update(6.0 + 0.5 * std::numeric_limits<double>::epsilon()), 1.2, 1e-12);
  EXPECT_NEAR(smoother.update(6.0), 6.0, 1e-9);  // the fifth in a row that agrees opens the gate
  EXPECT_NEAR(smoother.update(std::nan("")), 6.0, 1e-9);
}

TEST(Indentation, CountsOnlyWhatTheThesisPlaneMisses) {
  // At the middle each of the sensors sees only part of the depth; the plane believes it sees all.
  const Membrane membrane;
  const double side = membrane.shape(22, -3, 0, 0);
  const double back = membrane.shape(0, 27, 0, 0);
  const auto codes = [&](double at_s, std::uint64_t n) {
    return codesFor({100 - 6 * side, 100 - 6 * back, 100 - 6 * side}, at_s, n);
  };
  IndentationParameters p = membraneMode();
  IndentationEstimator membrane_way(p);
  p.mode = IndentationMode::thesis;
  IndentationEstimator thesis_way(p);
  IndentationEstimate a, b;
  for (int i = 1; i < 60; ++i) {
    const auto n = static_cast<std::uint64_t>(i);
    a = membrane_way.step(instantAt(0.0165 * i), codes(0.0165 * i, n), fingerAt(0, 0, 0.0165 * i));
    b = thesis_way.step(instantAt(0.0165 * i), codes(0.0165 * i, n), fingerAt(0, 0, 0.0165 * i));
  }
  EXPECT_NEAR(a.indentation_mm, 6.0, 0.25);
  EXPECT_NEAR(b.indentation_mm, 6 * (0.9 * side + 0.1 * back), 0.1);
  EXPECT_LT(b.indentation_mm, 3.0);
}

TEST(Indentation, AnotherModeKeepsNothingOfContactMode) {
  const auto pressedAt = [](IndentationEstimator& estimator, double from_s) {
    IndentationEstimate seen;
    for (int i = 0; i < 2000; ++i) {
      const double at_s = from_s + 0.001 * i;
      const auto count = static_cast<std::uint64_t>(1000.0 * at_s) + 1;
      auto finger = fingerAt(25.0, 0.0, at_s);
      finger.count = count;
      seen = estimator.step(instantAt(at_s), codesFor({97.5, 98.5, 99.0}, at_s, count), finger,
                            {.value = 2.0, .taken = instantAt(at_s), .count = count});
    }
    return seen;
  };
  IndentationParameters contact;
  contact.mode = IndentationMode::contact;
  IndentationEstimator switched(contact);
  (void)pressedAt(switched, 1.0);
  switched.configure(membraneMode());
  IndentationEstimator fresh(membraneMode());
  const IndentationEstimate after = pressedAt(switched, 4.0), alone = pressedAt(fresh, 4.0);
  ASSERT_TRUE(alone.available);
  EXPECT_NEAR(after.indentation_mm, alone.indentation_mm, 1e-6);
  EXPECT_NEAR(after.sigma_mm, alone.sigma_mm, 1e-6);
}

TEST(Indentation, ALiftedFingerIsZeroAndNoFault) {
  IndentationEstimator estimator(membraneMode());
  const IndentationEstimate e = estimator.step(instantAt(1), codesFor({97, 99, 98}, 1), fingerAt(0, 0, 1, false));
  EXPECT_TRUE(e.available);
  EXPECT_FALSE(e.touched);
  EXPECT_EQ(e.indentation_mm, 0.0);
  EXPECT_EQ(e.reason, IndentationReason::untouched);
}

TEST(Indentation, StaleInputsAreUnavailableAndHoldTheLastValue) {
  IndentationEstimator estimator(membraneMode());
  estimator.setMaximumAges(std::chrono::milliseconds(100), std::chrono::milliseconds(250));
  IndentationEstimate e;
  for (int i = 1; i <= 60; ++i) {
    const double t = 0.0165 * i;
    e = estimator.step(instantAt(t), codesFor({97, 99, 97}, t, static_cast<std::uint64_t>(i)), fingerAt(0, 0, t));
  }
  const double held = e.indentation_mm;
  const double last = 0.0165 * 60;
  ASSERT_GT(held, 2.0);
  const Timed<IrCounts> ir = codesFor({97, 99, 97}, last, 60);
  e = estimator.step(instantAt(last + 0.101), ir, fingerAt(0, 0, last));
  EXPECT_EQ(e.reason, IndentationReason::ir_stale);
  EXPECT_FALSE(e.available);
  EXPECT_EQ(e.indentation_mm, held);
  e = estimator.step(instantAt(last + 0.251), codesFor({97, 99, 97}, last + 0.25, 61), fingerAt(0, 0, last));
  EXPECT_EQ(e.reason, IndentationReason::finger_stale);
  EXPECT_EQ(e.indentation_mm, held);
  EXPECT_EQ(estimator.step(instantAt(1), {}, {}).reason, IndentationReason::ir_stale);  // never came
}

TEST(Indentation, GoesOnWithoutAnInvalidSensorAndSaysSo) {
  for (const auto mode : {IndentationMode::membrane, IndentationMode::thesis}) {
    IndentationParameters p;
    p.mode = mode;
    IndentationEstimator estimator(p);
    Timed<IrCounts> ir = codesFor({97, 99, 97}, 1);
    ir.value[1] = 4095;
    const IndentationEstimate e = estimator.step(instantAt(1), ir, fingerAt(10, 0, 1));
    EXPECT_FALSE(e.valid[1]);
    EXPECT_TRUE(std::isnan(e.distance_mm[1]));
    EXPECT_TRUE(e.valid[0] && e.valid[2]);
    if (mode == IndentationMode::membrane) {
      EXPECT_TRUE(e.available);
      EXPECT_EQ(e.reason, IndentationReason::some_invalid);
    } else {  // two points make no plane
      EXPECT_FALSE(e.available);
      EXPECT_EQ(e.reason, IndentationReason::too_few_sensors);
    }
    ir.value[0] = 0;
    ++ir.count;
    EXPECT_EQ(estimator.step(instantAt(1), ir, fingerAt(10, 0, 1)).reason, IndentationReason::too_few_sensors);
  }
}

TEST(Indentation, TakesFourSensorsAndLosesOne) {
  IndentationParameters p;
  p.mode = IndentationMode::thesis;
  p.ir_x_mm = listOf(-20, 20, 20, -20);
  p.ir_y_mm = listOf(-20, -20, 20, 20);
  p.ir_offset_mm = listOf(100, 100, 100, 100);
  IndentationEstimator estimator(p);
  EXPECT_NEAR(estimator.conditionNumber(), 1.0, 1e-12);
  Timed<IrCounts> ir = codesFor({95, 95, 95}, 1);
  (void)ir.value.push(ir.value[0]);
  EXPECT_NEAR(estimator.step(instantAt(1), ir, fingerAt(3, 3, 1)).indentation_mm, 5.0, 0.05);
  ir.value[3] = 100;
  ++ir.count;
  const IndentationEstimate e = estimator.step(instantAt(1), ir, fingerAt(3, 3, 1));
  EXPECT_TRUE(e.available);
  EXPECT_EQ(e.reason, IndentationReason::some_invalid);
  EXPECT_NEAR(e.indentation_mm, 5.0, 0.05);
}

TEST(Tare, AveragesUntouchedReadings) {
  PressedClothOptions o;
  o.touch_at_s = 100;
  PressedCloth cloth(o);
  IndentationParameters p;
  p.ir_offset_mm = listOf(90, 110, 100);  // wrong
  IndentationEstimator estimator(p);
  Tare tare;
  tare.start(instantAt(0), 60);
  for (int i = 0; i < 3000 && tare.state() == TareState::running; ++i) {
    cloth.step();
    (void)tare.step(cloth.now, estimator.step(cloth.now, cloth.ir, cloth.finger), cloth.force_N);
  }
  ASSERT_EQ(tare.state(), TareState::done);
  ASSERT_EQ(tare.result().sensors, 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(tare.result().offset_mm[i], 100.0, 0.4);  // 0.78 mm of noise over √60
    EXPECT_NEAR(tare.result().spread_mm[i], 0.78, 0.25);
  }
  EXPECT_NEAR(tare.result().force_N, 0.0, 0.003);
  estimator.tare({tare.result().offset_mm.data(), 3});
  EXPECT_EQ(estimator.offsets_mm()[1], tare.result().offset_mm[1]);
}

TEST(Tare, FailsWhenTouchedInvalidUnsteadyOrStarved) {
  const Timed<double> force{.value = 0.1, .taken = instantAt(0), .count = 1};
  IndentationEstimate free;
  free.reason = IndentationReason::untouched;
  free.sensors = 1;
  free.distance_mm[0] = 100;
  Tare tare;
  EXPECT_EQ(tare.step(instantAt(0), free, force), TareState::idle);

  tare.start(instantAt(0), 10);
  EXPECT_EQ(tare.step(instantAt(0), pressed(3), force), TareState::touched);

  tare.start(instantAt(0), 10);
  IndentationEstimate invalid = free;
  invalid.count = 1;
  invalid.distance_mm[0] = std::nan("");
  EXPECT_EQ(tare.step(instantAt(0), invalid, force), TareState::invalid_sensor);

  tare.start(instantAt(0), 10);
  EXPECT_EQ(tare.step(instantAt(0), free, {.value = std::nan(""), .count = 1}), TareState::invalid_sensor);

  tare.start(instantAt(0), 10);
  EXPECT_EQ(tare.step(instantAt(1.4), free, force), TareState::running);
  EXPECT_EQ(tare.step(instantAt(1.6), free, force), TareState::too_slow);

  tare.start(instantAt(0), 10);
  TareState state = TareState::running;
  for (std::uint64_t i = 1; i <= 10; ++i) {
    IndentationEstimate swinging = free;
    swinging.count = i;
    swinging.distance_mm[0] = i % 2 == 0 ? 80 : 120;
    state = tare.step(instantAt(0.01), swinging, {.value = 0.1, .count = i});
  }
  EXPECT_EQ(state, TareState::unsteady);
}

TEST(Stiffness, ThesisIsTheBareRatioAndHoldsNearZero) {
  StiffnessParameters p;
  p.mode = StiffnessMode::thesis;
  StiffnessEstimator estimator(p);
  Timed<double> force{.value = 3.0, .taken = instantAt(1), .count = 1};
  StiffnessEstimate k = estimator.step(instantAt(1), force, pressed(5));
  EXPECT_TRUE(k.observable);
  EXPECT_NEAR(k.stiffness_N_per_mm, 0.6, 1e-12);
  for (const double depth : {0.9, 0.0, -3.0, 5e-324}) {
    k = estimator.step(instantAt(1), force, pressed(depth));
    EXPECT_FALSE(k.observable);
    EXPECT_EQ(k.reason, StiffnessReason::indentation_too_small);
    EXPECT_NEAR(k.stiffness_N_per_mm, 0.6, 1e-12);
  }
}

TEST(Stiffness, SaysWhyItIsNotObservableAndHoldsItsValue) {
  StiffnessEstimator estimator;
  EXPECT_FALSE(estimator.step(instantAt(0), {}, {}).known);
  Timed<double> force{.value = 3.0, .taken = instantAt(1), .count = 1};
  const double k = estimator.step(instantAt(1), force, pressed(6)).stiffness_N_per_mm;
  EXPECT_NEAR(k, 0.5, 0.01);
  const auto expect = [&](const Timed<double>& f, const IndentationEstimate& d, StiffnessReason reason) {
    const StiffnessEstimate e = estimator.step(instantAt(1), f, d);
    EXPECT_EQ(e.reason, reason) << toString(e.reason);
    EXPECT_FALSE(e.observable);
    EXPECT_TRUE(e.known);
    EXPECT_EQ(e.stiffness_N_per_mm, k);
  };
  expect({.value = 0.05, .taken = instantAt(1), .count = 2}, pressed(6), StiffnessReason::force_too_small);
  expect({.value = std::nan(""), .taken = instantAt(1), .count = 3}, pressed(6), StiffnessReason::force_unavailable);
  expect({.value = 3.0, .taken = instantAt(0.8), .count = 4}, pressed(6), StiffnessReason::force_unavailable);
  expect(force, pressed(0.5), StiffnessReason::indentation_too_small);
  expect(force, pressed(6, 30.0), StiffnessReason::uncertain);
  IndentationEstimate gone = pressed(6);
  gone.available = false;
  expect(force, gone, StiffnessReason::indentation_unavailable);
  gone = pressed(0);
  gone.available = true;
  gone.touched = false;
  expect(force, gone, StiffnessReason::untouched);
}

TEST(Stiffness, StartsAfreshAtEachTouch) {
  StiffnessEstimator estimator;
  StiffnessEstimate k;
  std::uint64_t n = 0;
  const auto press = [&](double stiffness) {
    for (int i = 0; i < 60; ++i) {
      const double t = 0.0082 * static_cast<double>(++n);
      k = estimator.step(instantAt(t), {.value = stiffness * 6, .taken = instantAt(t), .count = n}, pressed(6));
      if (i == 1) {
        EXPECT_NEAR(k.stiffness_N_per_mm, stiffness, 0.05 * stiffness) << "the last touch still weighs";
      }
    }
    EXPECT_NEAR(k.stiffness_N_per_mm, stiffness, 0.01 * stiffness);
    IndentationEstimate lifted = pressed(0);
    lifted.touched = false;
    (void)estimator.step(instantAt(0.0082 * static_cast<double>(n)), {}, lifted);
  };
  press(0.7);
  press(0.3);
}

TEST(Stiffness, FollowsAClothThatIsStretchedUnderAHeldFinger) {
  PressedClothOptions o;
  o.stiffness_N_per_mm = 0.5;
  o.wander_mm = 0;
  o.seed = 5;
  PressedCloth cloth(o);
  IndentationEstimator indentation(membraneMode());
  StiffnessEstimator stiffness;
  double squares = 0;
  int samples = 0;
  for (int i = 0; i < 3000; ++i) {
    const double t = cloth.sinceTouch_s();
    cloth.setStiffness(t < 1 ? 0.5 : std::min(0.7, 0.5 + 0.4 * (t - 1)));
    cloth.step();
    const StiffnessEstimate k =
        stiffness.step(cloth.now, cloth.force_N, indentation.step(cloth.now, cloth.ir, cloth.finger));
    if (t < 0.6) continue;
    ASSERT_TRUE(k.observable);
    squares += std::pow(k.stiffness_N_per_mm / cloth.stiffness_N_per_mm() - 1, 2);
    ++samples;
  }
  EXPECT_LT(std::sqrt(squares / samples), 0.07);
}

TEST(Stiffness, ItsUncertaintyCoversItsError) {
  int outside = 0;
  int samples = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    PressedClothOptions o;
    o.x_mm = -30 + 1.5 * static_cast<double>(seed);
    o.y_mm = 10;
    o.seed = seed;
    PressedCloth cloth(o);
    IndentationEstimator indentation(membraneMode());
    StiffnessEstimator stiffness;
    for (int i = 0; i < 1500; ++i) {
      cloth.step();
      const StiffnessEstimate k =
          stiffness.step(cloth.now, cloth.force_N, indentation.step(cloth.now, cloth.ir, cloth.finger));
      if (cloth.sinceTouch_s() < 0.4 || i % 100 != 0 || !k.observable) continue;
      ++samples;
      outside += std::abs(k.stiffness_N_per_mm - 0.6) > 2 * k.sigma_N_per_mm ? 1 : 0;
    }
  }
  ASSERT_GT(samples, 200);
  EXPECT_LT(outside, 0.1 * samples);  // 5 % for a Gaussian
}

}  // namespace
}  // namespace fyd::sensing
