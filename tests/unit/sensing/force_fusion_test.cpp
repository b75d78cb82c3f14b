// Indentation with help of the measured force, on a pressed membrane with the sensors' real rates and noise.
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/sensing/indentation.h"
#include "tests/not_a_number.h"

namespace fyd::sensing {
namespace {

/// Code whose thesis curve gives this distance, by bisection on the printed polynomial.
std::uint16_t codeAt(double distance_mm) {
  const auto distance = [](int code) {
    const double v = 3.3 * code / 4096.0;
    return 10.0 * (-4.6327 * std::pow(v, 5) + 39.954 * std::pow(v, 4) - 133.8297 * std::pow(v, 3) + 220.8604 * v * v -
                   188.5623 * v + 79.0712);
  };
  int low = 524;
  int high = 3408;
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (distance(middle) > distance_mm ? low : high) = middle;
  }
  return static_cast<std::uint16_t>(low);
}

struct Press {
  double x_mm = 10.0;
  double y_mm = 5.0;
  double stiffness_N_per_mm = 0.6;
  std::function<double(double)> depth_mm = [](double t) { return 4.0 + 3.0 * std::sin(6.0 * t); };
  std::function<double(double, double)> cell_N = [](double force, double) { return force; };  // what the cell says
};

struct Errors {
  double rms_mm = 0.0;
  double last_mm = 0.0;
  bool always_finite = true;
};

/// Five seconds of a press; errors from 0.5 s on.
Errors follow(const Press& press, bool with_force) {
  IndentationParameters parameters;
  parameters.mode = IndentationMode::membrane;  // whose formula makes these presses
  IndentationEstimator estimator(parameters);
  const Membrane membrane;
  std::mt19937 random(3);
  std::normal_distribution<double> noise_mm(0.0, 0.8);
  std::normal_distribution<double> noise_N(0.0, 0.005);
  Timed<IrCounts> ir;
  Timed<FingerDetection> finger;
  Timed<double> force;
  Errors errors;
  double squares = 0.0;
  int count = 0;
  for (int ms = 0; ms < 5000; ++ms) {
    const double t = 0.001 * ms;
    const Instant now = instantAt(10.0 + t);
    const double depth = press.depth_mm(t);
    if (ms % 17 == 0) {
      IrCounts counts;
      for (const auto& [x, y] : {std::pair{-22.0, -3.0}, {0.0, 27.0}, {22.0, -3.0}}) {
        (void)counts.push(codeAt(100.0 - depth * membrane.shape(x, y, press.x_mm, press.y_mm) + noise_mm(random)));
      }
      ir.set(counts, now);
    }
    if (ms % 33 == 0) {
      finger.set(
          {.contact = true, .area_px = 400, .x_mm = press.x_mm, .y_mm = press.y_mm, .reason = FingerReason::found},
          now);
    }
    if (ms % 8 == 0) force.set(press.cell_N(press.stiffness_N_per_mm * depth + noise_N(random), t), now);
    const IndentationEstimate estimate =
        with_force ? estimator.step(now, ir, finger, force) : estimator.step(now, ir, finger);
    errors.always_finite =
        errors.always_finite && std::isfinite(estimate.indentation_mm) && std::isfinite(estimate.sigma_mm);
    errors.last_mm = estimate.indentation_mm - depth;
    if (ms < 500) continue;
    squares += errors.last_mm * errors.last_mm;
    ++count;
  }
  errors.rms_mm = std::sqrt(squares / count);
  return errors;
}

TEST(ForceFusion, AMovingPressIsFollowedSeveralTimesCloserThanByDistanceAlone) {
  const double alone = follow({}, false).rms_mm;
  const double fused = follow({}, true).rms_mm;
  EXPECT_LT(fused, 0.4 * alone) << "fused " << fused << " mm, distance alone " << alone << " mm";
  EXPECT_LT(fused, 0.35);
}

TEST(ForceFusion, ItHoldsForAClothMuchSofterOrStifferThanExpected) {
  for (const double stiffness : {0.25, 0.4, 0.9, 1.2}) {
    Press press;
    press.stiffness_N_per_mm = stiffness;
    EXPECT_LT(follow(press, true).rms_mm, 0.6 * follow(press, false).rms_mm) << stiffness << " N/mm";
  }
}

TEST(ForceFusion, ADeadLoadCellIsFoundOutAndTheDistancesServe) {
  Press press;
  press.depth_mm = [](double) { return 6.0; };
  press.cell_N = [](double, double) { return 0.0; };
  EXPECT_NEAR(follow(press, true).last_mm, 0.0, 1.0);
}

TEST(ForceFusion, ALoadCellThatSticksWhileTheFingerRisesIsFoundOut) {
  Press press;
  press.depth_mm = [](double t) { return t < 2.0 ? 7.0 : 2.0; };
  press.cell_N = [](double force, double t) { return t < 2.0 ? force : 4.2; };
  EXPECT_NEAR(follow(press, true).last_mm, 0.0, 1.2);
}

TEST(ForceFusion, AForceWithoutIndentationMakesNone) {
  Press press;
  press.depth_mm = [](double) { return 0.0; };
  press.cell_N = [](double, double) { return 3.0; };
  EXPECT_LT(std::abs(follow(press, true).last_mm), 1.0);
}

TEST(ForceFusion, WhatIsNotANumberFallsBackToTheDistances) {
  for (const double nasty : {kNaN, std::numeric_limits<double>::infinity(), -1e308, 1e308, 5e-324}) {
    Press press;
    press.depth_mm = [](double) { return 5.0; };
    press.cell_N = [nasty](double force, double t) { return t > 1.0 ? nasty : force; };
    const Errors errors = follow(press, true);
    EXPECT_TRUE(errors.always_finite) << nasty;
    EXPECT_LT(std::abs(errors.last_mm), 1.5) << nasty;
  }
}

}  // namespace
}  // namespace fyd::sensing
