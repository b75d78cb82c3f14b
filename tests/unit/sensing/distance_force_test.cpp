// Distances, plane, membrane and load cell against numbers worked out by hand or by an independent method.
#include <array>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/sensing/cloth_plane.h"
#include "core/sensing/ir_distance.h"
#include "core/sensing/load_cell.h"
#include "core/sensing/membrane.h"
#include "tests/sweep.h"

namespace fyd::sensing {
namespace {

constexpr std::array<SensorPosition, 3> kThesisSensors = {{{-22, -3}, {0, 27}, {22, -3}}};

TEST(IrDistance, FollowsTheThesisPolynomialByHand) {
  // Code 1241: v = 3.3·1241/4096 = 0.9998291; at v = 1 the six coefficients sum to 12.6781 cm.
  // 790.712 − 1885.623 + 2208.604 − 1338.297 + 399.54 − 46.327 = 128.609 mm; slope there −1885.623 + 4417.208 −
  // 4014.891
  // + 1598.16 − 231.635 = −116.781 mm/V, so 0.0001709 V below it reads 0.01996 mm more.
  const IrReading reading = IrDistance().read(1241);
  ASSERT_TRUE(reading.valid);
  EXPECT_NEAR(reading.distance_mm, 128.609 + 0.01996, 2e-4);
  EXPECT_NEAR(reading.slope_mm_per_V, 116.81, 0.1);
}

TEST(IrDistance, TwentyFiveMillivoltsAreTwoMillimetresAtAHundred) {
  const IrDistance sensor;
  const auto code = static_cast<std::uint16_t>(std::lround(sensor.voltsAt(100.0) / 3.3 * 4096));
  const IrReading reading = sensor.read(code);
  EXPECT_NEAR(reading.distance_mm, 100.0, 0.1);
  EXPECT_NEAR(reading.slope_mm_per_V * 0.025, 1.96, 0.03);
}

TEST(IrDistance, CodesOutsideTheSpanAreNoDistance) {
  const IrDistance sensor;
  for (const int code : {0, 1, 523, 3409, 3661, 4095, 65535}) {
    const IrReading reading = sensor.read(static_cast<std::uint16_t>(code));
    EXPECT_FALSE(reading.valid) << code;
    EXPECT_TRUE(std::isnan(reading.distance_mm)) << code;
  }
  EXPECT_NEAR(sensor.read(524).distance_mm, 300.0, 1.0);
  EXPECT_NEAR(sensor.read(3408).distance_mm, 40.0, 0.5);
}

TEST(IrDistance, FallsOverTheWholeSpan) {
  const IrDistance sensor;
  double before = std::numeric_limits<double>::infinity();
  for (std::uint16_t code = 524; code <= 3408; ++code) {
    const double d = sensor.read(code).distance_mm;
    ASSERT_LT(d, before) << code;
    before = d;
  }
}

TEST(IrDistance, TakesASensorsOwnCurveAndSpan) {
  const std::array<double, 2> line = {200.0, -50.0};
  const IrDistance sensor(line, 100, 200);
  EXPECT_NEAR(sensor.read(150).distance_mm, 200.0 - 50.0 * 3.3 * 150 / 4096, 1e-9);
  EXPECT_FALSE(sensor.read(99).valid);
  EXPECT_FALSE(sensor.read(201).valid);
}

TEST(IrDistance, TakesTheInverseForm) {
  const std::array<double, 3> abc = {120.0, 0.1, -2.0};
  const IrDistance sensor(abc, 500, 3400, IrCurveForm::inverse);
  const double v = 3.3 * 1241 / 4096;
  EXPECT_NEAR(sensor.read(1241).distance_mm, 120.0 / (v + 0.1) - 2.0, 1e-12);
  EXPECT_NEAR(sensor.read(1241).slope_mm_per_V, 120.0 / ((v + 0.1) * (v + 0.1)), 1e-9);
  EXPECT_NEAR(sensor.distance_mm(sensor.voltsAt(80.0)), 80.0, 1e-9);
}

TEST(IrDistance, AnInverseFormThatIsNoneReadsNothing) {
  const std::array<double, 2> two = {120.0, 0.1};
  EXPECT_FALSE(IrDistance(two, 500, 3400, IrCurveForm::inverse).read(1241).valid);
  const std::array<double, 3> pole = {120.0, -voltsFromCode(1241), 0.0};
  EXPECT_FALSE(IrDistance(pole, 500, 3400, IrCurveForm::inverse).read(1241).valid);
  EXPECT_NEAR(IrDistance({}, 524, 3408, IrCurveForm::inverse).read(1241).distance_mm, 128.629, 1e-2);  // thesis
}

TEST(ClothPlane, EqualsThePrintedFormulaForTheThesisSensors) {
  ClothPlane plane;
  ASSERT_TRUE(plane.solve(kThesisSensors, 0b111, 20));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-50, 50);
  for (int i = 0; i < 100; ++i) {
    const double x = any(random), y = any(random), a = any(random), b = any(random), c = any(random);
    const PlaneWeights w = plane.weightsAt(x, y);
    EXPECT_NEAR(w.weight[0] * a + w.weight[1] * b + w.weight[2] * c, thesisPlane(a, b, c, x, y), 1e-9);
  }
  // By hand, z = (1, 2, 3) at (11, 9): 0.45 + 0.2 + 1.35 − 0.25 + 0.75 − 0.15 + 0.6 − 0.45 = 2.5
  EXPECT_NEAR(thesisPlane(1, 2, 3, 11, 9), 2.5, 1e-12);
}

TEST(ClothPlane, HasTheStatedNoiseGains) {
  ClothPlane plane;
  ASSERT_TRUE(plane.solve(kThesisSensors, 0b111, 20));
  EXPECT_NEAR(plane.weightsAt(0, 0).noise_gain, 0.644, 0.001);
  EXPECT_NEAR(plane.weightsAt(22, -3).noise_gain, 1.0, 1e-12);
  EXPECT_NEAR(plane.weightsAt(50, -35).noise_gain, 2.42, 0.005);
  // C = diag(968, 600): √(968/600)
  EXPECT_NEAR(plane.conditionNumber(), 1.2702, 1e-4);
}

TEST(ClothPlane, FitsFourSensorsByLeastSquares) {
  const std::array<SensorPosition, 4> square = {{{-10, -10}, {10, -10}, {10, 10}, {-10, 10}}};
  ClothPlane plane;
  ASSERT_TRUE(plane.solve(square, 0b1111, 20));
  EXPECT_NEAR(plane.conditionNumber(), 1.0, 1e-12);
  // One corner lifted by 4: mean 1, slopes 4/40 each way; at that corner 1 + 1 + 1 = 3.
  const PlaneWeights w = plane.weightsAt(10, 10);
  EXPECT_NEAR(4 * w.weight[2], 3.0, 1e-12);
}

TEST(ClothPlane, RefusesTooFewAndNearlyCollinearSensors) {
  ClothPlane plane;
  EXPECT_FALSE(plane.solve(kThesisSensors, 0b011, 20));
  EXPECT_TRUE(std::isinf(plane.conditionNumber()));
  const std::array<SensorPosition, 3> line = {{{-20, 0}, {0, 0}, {20, 0}}};
  EXPECT_FALSE(plane.solve(line, 0b111, 1e12));
  const std::array<SensorPosition, 3> nearly = {{{-20, 0}, {0, 0.5}, {20, 0}}};
  EXPECT_FALSE(plane.solve(nearly, 0b111, 20));
  EXPECT_NEAR(plane.conditionNumber(), std::sqrt(800.0 / (1.0 / 6.0)), 1e-6);  // Σ(y − ȳ)² = 1/6
  EXPECT_EQ(plane.weightsAt(1, 1).noise_gain, 0.0);
  const std::array<SensorPosition, 3> broken = {{{std::nan(""), 0}, {0, 27}, {22, -3}}};
  EXPECT_FALSE(plane.solve(broken, 0b111, 20));
}

TEST(LoadCell, FollowsThePrintedFormulaByHand) {
  const LoadCell cell;
  // (1004.8805·0.8 − 20.2512)/1000·9.80665 = 783.6532/1000·9.80665
  EXPECT_NEAR(cell.force_N(0.8), 7.68501, 1e-4);
  EXPECT_NEAR(cell.force_N(0.0), -0.19860, 1e-5);
}

TEST(LoadCell, InvalidIsNotANumberAndNeverZero) {
  const LoadCell cell;
  for (const double bad : {7.78, -7.78, 1e300, std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    EXPECT_TRUE(std::isnan(cell.force_N(bad))) << bad;
  }
  EXPECT_TRUE(std::isfinite(cell.force_N(5e-324)));
}

TEST(LoadCell, ABridgeAtTheEndOfItsConverterMeasuresNothingWhateverSpanIsConfigured) {
  for (const double span : {2.0, 7.77, 1000.0}) {  // 7.77: as profiles of the first version say
    const LoadCell cell({.limit_mV_per_V = span});
    for (const double end : {7.77, 7.7699, 7.76, 7.8125, static_cast<double>(7.77F)}) {
      EXPECT_TRUE(std::isnan(cell.force_N(end))) << end << " with a span of " << span;
      EXPECT_TRUE(std::isnan(cell.force_N(-end))) << -end << " with a span of " << span;
    }
  }
  EXPECT_TRUE(std::isfinite(LoadCell({.limit_mV_per_V = 7.77}).force_N(7.7))) << "another cell, of 6 mV/V or so";
}

TEST(LoadCell, TheDeliveredSpanIsTheCellsOwn) {
  const LoadCell cell;
  EXPECT_TRUE(std::isfinite(cell.force_N(0.8)));        // rated, 7.65 N
  EXPECT_TRUE(std::isfinite(cell.force_N(1.5 * 0.8)));  // where it breaks
  EXPECT_TRUE(std::isnan(cell.force_N(3.0 * 0.8)));
  EXPECT_TRUE(std::isnan(cell.force_N(-3.0 * 0.8)));
}

TEST(LoadCell, TareMakesThePresentForceZero) {
  LoadCell cell;
  cell.tare(cell.force_N(0.05));
  EXPECT_NEAR(cell.force_N(0.05), 0.0, 1e-12);
  cell.tare(cell.force_N(0.06));  // again, on top of the first
  EXPECT_NEAR(cell.force_N(0.06), 0.0, 1e-12);
  cell.tare(std::nan(""));
  EXPECT_NEAR(cell.force_N(0.06), 0.0, 1e-12);
}

std::size_t at(int i, int j) { return static_cast<std::size_t>(j) * 101 + static_cast<std::size_t>(i); }

/// Relaxation of Laplace's equation on a 1 mm grid, finger as a disc of ones.
std::vector<double> relaxed(double fx, double fy) {
  std::vector<double> u(std::size_t{101} * 71, 0.0);
  std::vector<bool> fixed(u.size(), false);
  for (int j = 1; j < 70; ++j) {
    for (int i = 1; i < 100; ++i) {
      if (std::hypot(i - 50 - fx, j - 35 - fy) > 7.0) continue;
      fixed[at(i, j)] = true;
      u[at(i, j)] = 1.0;
    }
  }
  for (int sweep = 0; sweep < 400; ++sweep) {
    for (int j = 1; j < 70; ++j) {
      for (int i = 1; i < 100; ++i) {
        if (fixed[at(i, j)]) continue;
        const double mean = 0.25 * (u[at(i - 1, j)] + u[at(i + 1, j)] + u[at(i, j - 1)] + u[at(i, j + 1)]);
        u[at(i, j)] += 1.93 * (mean - u[at(i, j)]);
      }
    }
  }
  return u;
}

TEST(Membrane, AgreesWithAFiniteDifferenceSolution) {
  const Membrane membrane;
  for (const auto& [fx, fy] : {std::pair{0.0, 0.0}, {20.0, 10.0}, {-35.0, 0.0}, {0.0, 20.0}}) {
    const std::vector<double> u = relaxed(fx, fy);
    double squares = 0.0;
    for (int j = 0; j < 71; ++j) {
      for (int i = 0; i < 101; ++i) {
        const double error = membrane.shape(i - 50, j - 35, fx, fy) - u[at(i, j)];
        ASSERT_LT(std::abs(error), 0.08) << i - 50 << ' ' << j - 35;
        squares += error * error;
      }
    }
    EXPECT_LT(std::sqrt(squares / static_cast<double>(u.size())), 0.012) << fx << ' ' << fy;
  }
}

TEST(Membrane, IsOneUnderTheDiscZeroOnTheFrameAndFallsBetween) {
  const Membrane membrane;
  EXPECT_EQ(membrane.shape(3, 4, 0, 0), 1.0);
  EXPECT_EQ(membrane.shape(50, 0, 0, 0), 0.0);
  EXPECT_EQ(membrane.shape(0, -35, 0, 0), 0.0);
  EXPECT_EQ(membrane.shape(1000, 0, 0, 0), 0.0);
  double before = 1.0;
  for (const double x : stepsBefore(7.5, 50, 0.5)) {
    const double u = membrane.shape(x, 0, 0, 0);
    EXPECT_LT(u, before);
    before = u;
  }
  EXPECT_LT(before, 0.02);
  EXPECT_NEAR(membrane.shape(22, -3, 10, 5), membrane.shape(-22, -3, -10, 5), 1e-5);  // mirror
}

TEST(Membrane, StaysFiniteEverywhereAndForAnyFinger) {
  const double bad[] = {0, 7, -43, 49.999, 50, -50, 35, 1e9, -1e300, 5e-324, std::nan(""), HUGE_VAL, -HUGE_VAL};
  for (const Membrane& membrane : {Membrane(), Membrane(std::nan(""), -1, 1e9), Membrane(35, 50, 0)}) {
    for (const double x : bad) {
      for (const double y : bad) {
        for (const double fx : bad) {
          for (const double fy : bad) {
            const double u = membrane.shape(x, y, fx, fy);
            ASSERT_TRUE(u >= 0.0 && u <= 1.0) << x << ' ' << y << ' ' << fx << ' ' << fy;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace fyd::sensing
