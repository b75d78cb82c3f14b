// Orientation by its own truth: rotations made with Eigen, errors in degrees by Eigen.
#include "core/teleop/prediction/orientation_predictor.h"
#include "core/teleop/prediction/predictor_choice.h"

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/not_a_number.h"

namespace fyd::teleop {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kWholeTurn = 2.0 * std::numbers::pi;

Quaterniond of(const Orientation& q) { return {q.w, q.x, q.y, q.z}; }
Orientation of(const Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }
double degrees(const Quaterniond& a, const Quaterniond& b) { return a.angularDistance(b) * 360.0 / kWholeTurn; }

using Motion = std::function<Quaterniond(double)>;

/// Turns through ±180° again and again about a tilted axis.
const Motion kSpin = [](double t) { return Quaterniond(AngleAxisd(3.0 * t, Vector3d(1.0, 2.0, -0.5).normalized())); };
/// A hand that nods through ±90° (where roll and yaw are one) while it rolls and yaws.
const Motion kNod = [](double t) {
  return AngleAxisd(1.2 * std::sin(5.0 * t), Vector3d::UnitZ()) *
         AngleAxisd(1.8 * std::sin(7.0 * t), Vector3d::UnitY()) *
         AngleAxisd(2.5 * std::sin(3.0 * t), Vector3d::UnitX());
};
/// About an axis that turns itself, past ±180°.
const Motion kWobble = [](double t) {
  return AngleAxisd(4.0 * t, Vector3d::UnitZ()) * AngleAxisd(2.6 + 1.0 * std::sin(6.0 * t), Vector3d::UnitX());
};

struct Errors {
  double rms = 0.0, worst = 0.0;
};

Errors run(const Motion& motion, const std::function<void(double, const Quaterniond&)>& message,
           const std::function<Quaterniond(double)>& predict, double delay_s) {
  Errors out;
  std::multimap<double, double> underway;  // arrival → date
  int ticks = 0;
  for (int i = 0; i < 6000; ++i) {
    const double now = 0.001 * i;
    if (i % 10 == 0) underway.emplace(now + delay_s, now);
    for (; !underway.empty() && underway.begin()->first <= now + 1e-9; underway.erase(underway.begin())) {
      message(underway.begin()->second, motion(underway.begin()->second));
    }
    const double error = degrees(predict(now), motion(now));
    if (i < 500) continue;
    out.rms += error * error;
    out.worst = std::max(out.worst, error);
    ++ticks;
  }
  out.rms = std::sqrt(out.rms / ticks);
  return out;
}

Errors run(std::string_view name, const Motion& motion, double delay_s) {
  OrientationPredictor predictor(predictorNamed(name).value(), 0.010);
  bool opposite = false;
  return run(
      motion,
      [&](double date, const Quaterniond& q) {
        opposite = !opposite;  // the sign of a quaternion says nothing
        predictor.message(date, of(opposite ? Quaterniond(-q.coeffs()) : q));
      },
      [&](double now) { return of(predictor.predict(now)); }, delay_s);
}

TEST(OrientationPredictor, ASteadyTurnThrough180DegreesIsFollowed) {
  EXPECT_LT(run("order1", kSpin, 0.05).worst, 0.01);
  EXPECT_LT(run("default", kSpin, 0.05).worst, 0.5);
  // Held: 3 rad/s · (50 … 59 ms).
  EXPECT_NEAR(run("order0", kSpin, 0.05).worst, 3.0 * 0.059 * 360.0 / kWholeTurn, 0.01);
}

TEST(OrientationPredictor, EveryPredictorIsOfUseWhereAnglesFail) {
  for (const Motion& motion : {kNod, kWobble}) {
    for (const double delay_s : {0.01, 0.05}) {
      const Errors hold = run("order0", motion, delay_s);
      for (const std::string_view name : kPredictorNames) {
        if (name == "order0") continue;
        const Errors each = run(name, motion, delay_s);

        EXPECT_LT(each.rms, 0.6 * hold.rms) << name << ", " << delay_s;
        EXPECT_LT(each.worst, 1.2 * hold.worst) << name << ", " << delay_s;
      }
      EXPECT_LT(run("default", motion, delay_s).rms, run("order1", motion, delay_s).rms) << delay_s;
    }
  }
}

TEST(OrientationPredictor, AngleByAngleTheSameMotionsAreLost) {
  // What the sphere is for: yaw, pitch and roll, each predicted by itself, as an angle within ±180°.
  const auto predictor = makePredictor(PredictorChoice::order1, {.axes = 3, .period_s = 0.010});
  const auto angle = [&](double date, const Quaterniond& q) {
    const Vector3d zyx = q.toRotationMatrix().eulerAngles(2, 1, 0);
    predictor->message(date, {100.0 * zyx[0], 100.0 * zyx[1], 100.0 * zyx[2]});
  };
  const auto rotation = [&](double now) {
    const Position a = predictor->predict(now);
    return Quaterniond(AngleAxisd(0.01 * a[0], Vector3d::UnitZ()) * AngleAxisd(0.01 * a[1], Vector3d::UnitY()) *
                       AngleAxisd(0.01 * a[2], Vector3d::UnitX()));
  };
  EXPECT_GT(run(kNod, angle, rotation, 0.05).worst, 150.0);
  EXPECT_LT(run("order1", kNod, 0.05).worst, 60.0);
}

TEST(OrientationPredictor, OvertakenDoubledAndBrokenMessagesAreTakenOrPassedOver) {
  OrientationPredictor predictor(PredictorChoice::order1, 0.010);
  EXPECT_EQ(degrees(of(predictor.predict(3.0)), Quaterniond::Identity()), 0.0);
  predictor.message(0.00, of(kSpin(0.0)));
  predictor.message(0.02, of(kSpin(0.02)));
  predictor.message(0.01, of(kSpin(0.01)));  // overtaken: it stands in its place
  predictor.message(0.02, of(kSpin(1.0)));   // of a date that is known
  predictor.message(0.03, {kNaN, 0.0, 0.0, 0.0});
  predictor.message(0.03, {0.0, 0.0, 0.0, 0.0});
  predictor.message(kNaN, of(kSpin(0.5)));
  EXPECT_LT(degrees(of(predictor.predict(0.06)), kSpin(0.06)), 0.01);
  predictor.message(0.03,
                    {1.05 * kSpin(0.03).w(), 1.05 * kSpin(0.03).x(), 1.05 * kSpin(0.03).y(), 1.05 * kSpin(0.03).z()});
  EXPECT_LT(degrees(of(predictor.predict(0.06)), kSpin(0.06)), 0.01);
  const Orientation q = predictor.predict(kNaN);
  EXPECT_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1.0, 1e-12);
}

TEST(OrientationPredictor, BetweenTwoMotionsThereIsNoRotation) {
  for (const std::string_view name : kPredictorNames) {
    OrientationPredictor predictor(predictorNamed(name).value(), 0.010);
    for (int i = 0; i < 100; ++i) predictor.message(0.01 * i, of(kSpin(0.01 * i)));
    predictor.endMotion();
    EXPECT_EQ(degrees(of(predictor.predict(1.0)), Quaterniond::Identity()), 0.0) << name;
    predictor.message(1.5, of(kSpin(4.0)));  // the hand comes back elsewhere
    EXPECT_LT(degrees(of(predictor.predict(1.5)), kSpin(4.0)), 1e-6) << name;
  }
}

TEST(OrientationPredictor, AnglesAreAboutTheOuterAxesOneAfterTheOther) {
  const Quaterniond truth =
      AngleAxisd(0.7, Vector3d::UnitZ()) * AngleAxisd(-1.1, Vector3d::UnitY()) * AngleAxisd(2.0, Vector3d::UnitX());
  EXPECT_NEAR(degrees(of(fromAngles(2.0, -1.1, 0.7)), truth), 0.0, 1e-6);
  EXPECT_NEAR(angle_deg(fromAngles(0.0, 0.0, 0.1), fromAngles(0.0, 0.0, -0.4)), 0.5 * 360.0 / kWholeTurn, 1e-9);
}

}  // namespace
}  // namespace fyd::teleop
