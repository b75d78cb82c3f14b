// Sensors and their calibration.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>

#include "app/bench/parts/hard_case.h"
#include "core/calibration/encoder_calibration.h"
#include "core/calibration/fit/least_squares.h"
#include "core/calibration/fit/polynomial_basis.h"
#include "core/calibration/load_cell_calibration.h"
#include "core/sensing/finger_detector.h"
#include "core/sensing/ir_distance.h"
#include "core/sensing/stiffness_estimator.h"

namespace fyd::bench {
namespace {

/// Slope of a line by the formula with sums of products.
double slopeBySums(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  const double sx = std::accumulate(x.begin(), x.end(), 0.0), sy = std::accumulate(y.begin(), y.end(), 0.0);
  return (n * std::inner_product(x.begin(), x.end(), y.begin(), 0.0) - sx * sy) /
         (n * std::inner_product(x.begin(), x.end(), x.begin(), 0.0) - sx * sx);
}

double relative(double value, double truth) { return std::abs(value / truth - 1.0); }

HardCase lineFarFromZero() {
  calibration::LoadCellSamples samples;
  for (int i = 0; i < 10; ++i) {
    samples.value_mV_per_V.push_back(900.0 + 0.01 * i);
    samples.force_N.push_back(98.0 * 0.01 * i);
  }
  const auto found = calibration::calibrateLoadCell(samples, {});
  return {
      .name = "slope of a load cell whose readings lie at 900.00 to 900.09",
      .naive = "n·Σxy − Σx·Σy over n·Σx² − (Σx)²",
      .ours = "about the mean, scaled, Householder QR (`calibration::calibrateLoadCell`)",
      .truth = "exact by construction: 98",
      .unit = "relative",
      .naive_error = relative(slopeBySums(samples.value_mV_per_V, samples.force_N), 98.0),
      .our_error = found.result.coefficients.empty() ? kNotFinite : relative(found.result.coefficients[0].value, 98.0),
      .at_most = 1e-10};
}

HardCase quinticOverAFewCodes() {
  constexpr int kPoints = 64, kDegree = 5;
  const sensing::IrDistance curve;
  std::vector<double> codes;
  Eigen::VectorXd truth(kPoints);
  Eigen::MatrixXd powers(kPoints, kDegree + 1);
  for (int i = 0; i < kPoints; ++i) {
    codes.push_back(2000.0 + 200.0 * i / (kPoints - 1));
    truth[i] = curve.distance_mm(sensing::voltsFromCode(codes.back()));
    for (int j = 0; j <= kDegree; ++j) powers(i, j) = std::pow(codes.back(), j);
  }
  const Eigen::VectorXd naive = (powers.transpose() * powers).ldlt().solve(powers.transpose() * truth);
  const calibration::PolynomialBasis basis(codes, kDegree);
  const Eigen::MatrixXd design = basis.design(codes);
  const auto ours = calibration::fitLinear(design, truth);
  return {.name = "a quintic through 64 exact points over codes 2000 to 2200",
          .naive = "normal equations on powers of the codes",
          .ours = "Chebyshev polynomials on the span, QR (`calibration::PolynomialBasis`)",
          .truth = "the points themselves, which lie on a quintic",
          .unit = "mm",
          .naive_error = (powers * naive - truth).cwiseAbs().maxCoeff(),
          .our_error = ours ? (design * ours->coefficients - truth).cwiseAbs().maxCoeff() : kNotFinite,
          .at_most = 1e-10};
}

HardCase distanceBeyondTheSpan() {
  constexpr double kNearest_mm = 40.0, kFarthest_mm = 300.0;
  const sensing::IrDistance sensor;
  HardCase out{.name = "codes 0 to 4095 of a distance sensor for 40 to 300 mm: a distance that it claims beyond",
               .naive = "the thesis' polynomial for every code: negative, or 790 mm",
               .ours = "no distance outside of the span (`sensing::IrDistance::read`)",
               .truth = "the data sheet's span",
               .unit = "mm outside",
               .at_most = 0.5};
  const auto outside = [](double mm) { return std::max({0.0, kNearest_mm - mm, mm - kFarthest_mm}); };
  for (int code = 0; code < sensing::kAdcCodes; ++code) {
    out.naive_error = std::max(out.naive_error, outside(sensor.distance_mm(sensing::voltsFromCode(code))));
    const sensing::IrReading reading = sensor.read(code);
    if (reading.valid) out.our_error = std::max(out.our_error, outside(reading.distance_mm));
  }
  return out;
}

HardCase stiffnessOfALiftedFinger() {
  constexpr double kTruth_N_per_mm = 0.6, kTareError_N = 0.02;
  sensing::StiffnessEstimator estimator;
  sensing::IndentationEstimate depth{.sigma_mm = 0.05, .available = true, .touched = true};
  Timed<double> force;
  HardCase out{.name = "stiffness while a finger is lifted to 0.01 mm, the force's zero 0.02 N off",
               .naive = "force over indentation",
               .ours = "slope and intercept, held where it cannot be observed (`sensing::StiffnessEstimator`)",
               .truth = "the simulated cloth's 0.6 N/mm",
               .unit = "relative",
               .at_most = 0.1};
  for (int ms = 1; ms <= 4000; ++ms) {
    const Instant now = instantAt(1e-3 * ms);
    depth.indentation_mm = std::max(0.01, ms < 1000 ? 5e-3 * ms : 5.0 - 2.5e-3 * (ms - 1000));
    depth.taken = now;
    ++depth.count;
    force.set(kTruth_N_per_mm * depth.indentation_mm + kTareError_N, now);
    const sensing::StiffnessEstimate estimate = estimator.step(now, force, depth);
    if (ms < 900) continue;
    out.naive_error = std::max(out.naive_error, relative(force.value / depth.indentation_mm, kTruth_N_per_mm));
    out.our_error =
        std::max(out.our_error, estimate.known ? relative(estimate.stiffness_N_per_mm, kTruth_N_per_mm) : kNotFinite);
  }
  return out;
}

HardCase pictureWithoutContrast() {
  // Every pixel is equal: the printed σ = (max − min)/5 is 0.
  const std::vector<std::uint8_t> grey(std::size_t{320} * 240, 100);
  const double value = grey[0], darkest = value, sigma = (value - darkest) / 5.0;
  const double weight = std::exp(-(value - darkest) * (value - darkest) / (2.0 * sigma * sigma));
  const double naive_px = weight * 160.0 / weight;
  sensing::FingerParameters parameters;
  parameters.mode = sensing::FingerMode::thesis;
  sensing::FingerDetector detector(parameters);
  const auto seen = detector.detect({.data = grey.data(), .width = 320, .height = 240, .stride = 320, .channels = 1});
  return {.name = "a picture without contrast: positions that are no number",
          .naive = "weights exp(−(I − µ)²/2σ²) with σ = 0, as printed",
          .ours = "is no finger, and says why (`sensing::FingerDetector`)",
          .truth = "by definition: none",
          .unit = "of 1 picture",
          .naive_error = std::isfinite(naive_px) ? 0.0 : 1.0,
          .our_error = std::isfinite(seen.x_px) && std::isfinite(seen.x_mm) && !seen.contact ? 0.0 : 1.0,
          .at_most = 0.0};
}

HardCase encoderOverItsEnd() {
  constexpr double kTruth = 4096.0 / 360.0;
  calibration::EncoderSamples samples;
  for (std::size_t motor = 0; motor < samples.counts.size(); ++motor) {
    for (int deg = 0; deg <= 90; deg += 5) {
      samples.command_deg[motor].push_back(deg);
      samples.counts[motor].push_back(std::fmod(4000.0 + kTruth * deg, 4096.0));
    }
  }
  const auto found = calibration::calibrateEncoders(samples, {});
  return {.name = "counts per degree of an encoder that passes from 4095 to 0",
          .naive = "a line through the counts",
          .ours = "unwrapped along the sweep (`calibration::calibrateEncoders`)",
          .truth = "by construction: 4096/360",
          .unit = "relative",
          .naive_error = relative(slopeBySums(samples.command_deg[0], samples.counts[0]), kTruth),
          .our_error = relative(found.encoders[0].counts_per_deg, kTruth),
          .at_most = 1e-9};
}

}  // namespace

std::vector<HardCase> hardCasesOfSensing() {
  return {lineFarFromZero(),          quinticOverAFewCodes(),   distanceBeyondTheSpan(),
          stiffnessOfALiftedFinger(), pictureWithoutContrast(), encoderOverItsEnd()};
}

}  // namespace fyd::bench
