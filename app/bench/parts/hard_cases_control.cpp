// Control, observers and predictors.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/bench/parts/hard_case.h"
#include "core/control/pid.h"
#include "core/control/scale_observer.h"
#include "core/teleop/prediction/linear_forecast.h"
#include "core/teleop/prediction/orientation_predictor.h"
#include "core/teleop/prediction/predictor_choice.h"

namespace fyd::bench {
namespace {

HardCase integratorAtItsStop() {
  constexpr double kStep_s = 1e-3, kHeld_s = 60.0;
  control::Pid ours({.kp = 0.5, .ki = 1.0}, {.minimum = -1.0, .maximum = 1.0});
  double integral = 0.0, naive = 0.0, ours_at = 0.0;
  double naive_late_s = 0.0, our_late_s = 0.0;
  for (int i = 0; i < static_cast<int>(3.0 * kHeld_s / kStep_s); ++i) {
    const double error = kStep_s * i < kHeld_s ? 1.0 : -1.0;
    integral += error * kStep_s;
    naive = std::clamp(0.5 * error + integral, -1.0, 1.0);
    ours_at = ours.step(error, 0.0, kStep_s);
    if (error > 0.0) continue;
    if (naive >= 1.0) naive_late_s += kStep_s;
    if (ours_at >= 1.0) our_late_s += kStep_s;
  }
  return {.name = "a PI controller after a minute at its limit: time until it leaves it",
          .naive = "the integral goes on",
          .ours = "the integral stops while it pushes outward (`control::Pid`)",
          .truth = "the error has changed its sign: 0",
          .unit = "s",
          .naive_error = naive_late_s,
          .our_error = our_late_s,
          .at_most = 0.001};
}

HardCase varianceThatFallsFast() {
  // Ṗ = q² − P²/r with a late step of 20 ms. A reading that does not scatter has r = 2·Tc·v, v = max(σ²·decay, 0.35·σ²).
  constexpr double kStep_s = 0.02, kSigma = 0.01, kCorrelation_s = 0.4, kWander2 = 0.003 * 0.003;
  constexpr int kSteps = 10, kFine = 20'000;
  control::ScaleObserver ours;
  ours.configure(kCorrelation_s);
  ours.reset();
  double naive = 0.0625;
  long double truth = 0.0625L;
  double scatter = kSigma * kSigma;
  for (int i = 0; i < kSteps; ++i) {
    ours.step(0.0, kSigma, 0.0, kStep_s);
    scatter += (0.0 - scatter) * kStep_s / (0.4 + kStep_s);
    const double r = 2.0 * kCorrelation_s * std::max(scatter, 0.35 * kSigma * kSigma);
    naive += kStep_s * (kWander2 - naive * naive / r);
    for (int k = 0; k < kFine; ++k) truth += static_cast<long double>(kStep_s) / kFine * (kWander2 - truth * truth / r);
  }
  const double sigma = std::sqrt(static_cast<double>(truth));
  return {.name = "standard deviation of a Kalman–Bucy filter after ten steps of 20 ms",
          .naive = "explicit Euler on Ṗ = q² − P²/r: P becomes negative",
          .ours = "inverse variances add, exact over a step (`control::ScaleObserver`)",
          .truth = "20 000 times finer in long double",
          .unit = "relative",
          .naive_error = naive > 0.0 && std::isfinite(naive) ? std::abs(std::sqrt(naive) / sigma - 1.0) : kNotFinite,
          .our_error = std::abs(ours.sigma() / sigma - 1.0),
          .at_most = 0.01};
}

HardCase learningAfterALongRest() {
  constexpr int kRest = 100'000, kMotion = 300;
  constexpr double kForgetting = 0.99, kWay_mm = 0.1;
  teleop::LinearForecast ours;
  ours.begin({.order = 20, .forgetting = kForgetting}, 0.01);
  ours.setNodes({5, 0, 0});
  double p = 1.0, weight = 1.0;  // recursive least squares of one weight, as in textbooks
  teleop::LinearForecast::Features features{};
  for (int i = 0; i < kRest + kMotion; ++i) {
    const double way = i < kRest ? 0.0 : kWay_mm;
    for (std::size_t k = 0; k < 20; ++k) features[k] = way;
    ours.updatePower(way);
    ours.learn(features, {5.0 * way, 0.0, 0.0});
    const double gain = p * way / (kForgetting + way * p * way);
    weight += gain * (5.0 * way - weight * way);
    p = (p - gain * way * p) / kForgetting;
  }
  const double naive = weight * kWay_mm, truth = 5.0 * kWay_mm;
  return {.name = "a learnt forecast of a straight motion after 100 000 messages of rest",
          .naive = "recursive least squares, forgetting 0.99: P overflows",
          .ours = "does not forget without motion, begins anew above a limit (`teleop::LinearForecast`)",
          .truth = "closed form: speed · time",
          .unit = "relative",
          .naive_error = std::isfinite(naive) ? std::abs(naive / truth - 1.0) : kNotFinite,
          .our_error = std::abs(ours.forecast(0, features) / truth - 1.0),
          .at_most = 0.01};
}

HardCase turnThroughHalfATurn() {
  constexpr double kRate_rad_s = 2.0, kAhead_s = 0.055;
  teleop::OrientationPredictor ours(teleop::PredictorChoice::order1, 0.01);
  double last = 0.0, slope = 0.0;
  HardCase out{.name = "a steady turn through 180°, predicted 55 ms ahead",
               .naive = "the angle by atan2, extrapolated",
               .ours = "rotation vectors (`teleop::OrientationPredictor`)",
               .truth = "closed form",
               .unit = "°",
               .at_most = 0.5};
  for (int i = 0; i < 300; ++i) {
    const double date_s = 0.01 * i, angle = 0.5 + kRate_rad_s * date_s;
    ours.message(date_s, teleop::fromAngles(0.0, 0.0, angle));
    const double wrapped = std::atan2(std::sin(angle), std::cos(angle));
    slope = i == 0 ? 0.0 : (wrapped - last) / 0.01;
    last = wrapped;
    if (i < 20) continue;
    const teleop::Orientation truth = teleop::fromAngles(0.0, 0.0, angle + kRate_rad_s * kAhead_s);
    const double naive = wrapped + slope * kAhead_s;
    out.naive_error = std::max(out.naive_error, teleop::angle_deg(truth, teleop::fromAngles(0.0, 0.0, naive)));
    out.our_error = std::max(out.our_error, teleop::angle_deg(truth, ours.predict(date_s + kAhead_s)));
  }
  return out;
}

HardCase weightsOfExactForecasts() {
  // At rest the losses are 0 at last; in steady motion that of a straight line is of rounding alone.
  constexpr int kRest = 80'000, kMotion = 6'000, kAhead = 5;  // messages
  constexpr double kPeriod_s = 0.01, kWay_mm = 0.1, kForgetting = 0.99, kTruth_mm = kAhead * kWay_mm;
  const auto ours = teleop::makePredictor(teleop::PredictorChoice::experts, {.axes = 1, .period_s = kPeriod_s});
  std::array<double, kAhead + 2> at_mm{};           // the newest first
  double hold_loss_mm2 = 0.0, line_loss_mm2 = 0.0;  // of staying there, and of going on straight
  double by_naive_mm = 0.0, by_ours_mm = 0.0;
  for (int i = 0; i < kRest + kMotion; ++i) {
    std::shift_right(at_mm.begin(), at_mm.end(), 1);
    at_mm[0] = i < kRest ? 0.0 : at_mm[1] + kWay_mm;
    const double way_mm = at_mm[0] - at_mm[kAhead], line_mm = kAhead * (at_mm[kAhead] - at_mm[kAhead + 1]);
    hold_loss_mm2 = hold_loss_mm2 * kForgetting + way_mm * way_mm;
    line_loss_mm2 = line_loss_mm2 * kForgetting + (line_mm - way_mm) * (line_mm - way_mm);
    const double hold = 1.0 / std::pow(hold_loss_mm2, 16.0), line = 1.0 / std::pow(line_loss_mm2, 16.0);
    by_naive_mm = line / (hold + line) * kAhead * (at_mm[0] - at_mm[1]);
    ours->message(kPeriod_s * i, {at_mm[0]});
    by_ours_mm = ours->predict(kPeriod_s * (i + kAhead))[0] - at_mm[0];
  }
  return {.name = "forecasts weighted by loss⁻¹⁶, on a steady motion after 80 000 messages of rest",
          .naive = "1/loss¹⁶ of each over their sum: ∞/∞",
          .ours = "(least loss/loss)¹⁶ (`teleop::ExpertPredictor`)",
          .truth = "closed form: speed · time",
          .unit = "relative",
          .naive_error = std::isfinite(by_naive_mm) ? std::abs(by_naive_mm / kTruth_mm - 1.0) : kNotFinite,
          .our_error = std::isfinite(by_ours_mm) ? std::abs(by_ours_mm / kTruth_mm - 1.0) : kNotFinite,
          .at_most = 0.01};
}

}  // namespace

std::vector<HardCase> hardCasesOfControl() {
  return {integratorAtItsStop(), varianceThatFallsFast(), learningAfterALongRest(), turnThroughHalfATurn(),
          weightsOfExactForecasts()};
}

}  // namespace fyd::bench
