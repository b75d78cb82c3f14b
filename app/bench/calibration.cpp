// The fits of calibration: time beside error, against normal equations on powers of raw counts.
#include <cmath>
#include <random>

#include <Eigen/Cholesky>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/table.h"
#include "core/calibration/fit/least_squares.h"
#include "core/calibration/fit/polynomial_basis.h"
#include "core/calibration/ir_calibration.h"
#include "core/sensing/indentation_parameters.h"

namespace fyd::bench {
namespace {

constexpr int kPoints = 64, kDegree = 5;

struct Data {
  std::vector<double> codes;
  Eigen::VectorXd truth;  // the thesis curve, which is such a quintic
};

Data dataBetween(double lowest, double highest) {
  Data data{{}, Eigen::VectorXd(kPoints)};
  const sensing::IrDistance thesis;
  for (int i = 0; i < kPoints; ++i) {
    data.codes.push_back(lowest + (highest - lowest) * i / (kPoints - 1));
    data.truth[i] = thesis.distance_mm(sensing::voltsFromCode(data.codes.back()));
  }
  return data;
}

Eigen::VectorXd naive(const Data& data) {
  Eigen::MatrixXd powers(kPoints, kDegree + 1);
  for (int i = 0; i < kPoints; ++i) {
    for (int j = 0; j <= kDegree; ++j) powers(i, j) = std::pow(data.codes[static_cast<std::size_t>(i)], j);
  }
  const Eigen::VectorXd c = (powers.transpose() * powers).ldlt().solve(powers.transpose() * data.truth);
  return powers * c;
}

Eigen::VectorXd scaled(const Data& data) {
  const calibration::PolynomialBasis basis(data.codes, kDegree);
  const Eigen::MatrixXd design = basis.design(data.codes);
  const auto fit = calibration::fitLinear(design, data.truth);
  return fit ? Eigen::VectorXd(design * fit->coefficients) : Eigen::VectorXd::Constant(kPoints, std::nan(""));
}

}  // namespace

Table bench_calibration() {
  Table table;
  table.subject = "calibration";
  table.title = "Fits of a calibration against normal equations on raw powers";
  table.columns = {{"codes", Role::group},
                   {"method", Role::method},
                   {"p50", "µs", Role::cost},
                   {"p99", "µs"},
                   {"largest error", "mm", Role::error}};
  for (const auto& [name, lowest, highest] :
       {std::tuple{"524 to 3408", 524.0, 3408.0}, std::tuple{"2000 to 2200, clustered", 2000.0, 2200.0}}) {
    const Data data = dataBetween(lowest, highest);
    const auto add = [&, &span = name](const char* method, auto&& solve) {
      auto times = timeEach(wholeOrQuick(400, 20), [&] { (void)solve(data); });
      const Quantiles q = quantiles(times);
      const double error = (solve(data) - data.truth).cwiseAbs().maxCoeff();
      table.rows.push_back({span, method, number(q.p50 / 1000), number(q.p99 / 1000), number(error)});
    };
    add("baseline: normal equations, powers of codes", naive);
    add("Chebyshev on the span, QR, with uncertainty", scaled);
  }
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 6);
  calibration::IrSamples samples;
  const sensing::IrDistance thesis;
  for (int d = 40; d <= 300; d += 20) {
    for (int i = 0; i < 5; ++i) {
      samples.adc.push_back(thesis.voltsAt(d) * 4096 / 3.3 + noise(random));
      samples.distance_mm.push_back(d);
    }
  }
  double error = 0.0;
  auto times = timeEach(wholeOrQuick(10, 1), [&] {
    const auto found = calibration::calibrateIr(samples, {}, {});
    error = found.result.held_out_rmse;
  });
  table.notes = {
      "64 points of a quintic without noise: the error is the arithmetic's own.",
      fmt::format(
          "A whole calibration of a distance sensor (70 readings, 6 curves with cross-validation, outliers, every "
          "code checked): {} ms, held-out error {} mm with 6 counts of noise.",
          number(quantiles(times).p50 / 1e6), number(error))};
  return table;
}

}  // namespace fyd::bench
