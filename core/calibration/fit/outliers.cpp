#include "core/calibration/fit/outliers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include <Eigen/QR>

#include "core/calibration/fit/least_squares.h"
#include "core/calibration/fit/student_quantile.h"

namespace fyd::calibration {
namespace {

using Rows = std::vector<Eigen::Index>;

constexpr Eigen::Index kManyPoints = 2000;
constexpr int kStarts = 100, kStartsOfMany = 20;
constexpr int kConcentrations = 3;
constexpr double kRounding = 1e-9;  // of the values' span

/// |residual| of every row under the fit through some of them, divided by how uncertain it is but for sigma.
struct SubsetFit {
  Eigen::VectorXd residual;
  Eigen::VectorXd uncertainty;  // √(1 + h) outside the subset, √(1 − h) inside
  double sigma = 0.0;
  bool solved = false;
};

SubsetFit fitSubset(const Eigen::MatrixXd& design, const Eigen::VectorXd& y, const Rows& rows, bool with_uncertainty) {
  SubsetFit out;
  const auto count = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd a(count, design.cols());
  Eigen::VectorXd b(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    a.row(i) = design.row(rows[static_cast<std::size_t>(i)]);
    b[i] = y[rows[static_cast<std::size_t>(i)]];
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a);
  if (qr.rank() < design.cols()) return out;
  const Eigen::VectorXd x = qr.solve(b);
  out.residual = (y - design * x).cwiseAbs();
  out.solved = out.residual.allFinite();
  const double freedom = static_cast<double>(std::max<Eigen::Index>(1, count - design.cols()));
  out.sigma = (b - a * x).stableNorm() / std::sqrt(freedom);
  if (!with_uncertainty) return out;
  // h = aᵀ(AᵀA)⁻¹a = |R⁻ᵀPᵀa|²
  const Eigen::MatrixXd r = qr.matrixR().topRows(design.cols()).triangularView<Eigen::Upper>();
  const Eigen::MatrixXd turned = (design * qr.colsPermutation()).transpose();
  const Eigen::MatrixXd solved = r.transpose().triangularView<Eigen::Lower>().solve(turned);
  out.uncertainty = (1.0 + solved.colwise().squaredNorm().transpose().array()).sqrt();
  for (const Eigen::Index row : rows) {
    const double h = out.uncertainty[row] * out.uncertainty[row] - 1.0;
    out.uncertainty[row] = std::sqrt(std::max(1e-6, 1.0 - h));
  }
  return out;
}

Rows smallest(const Eigen::VectorXd& values, Eigen::Index count) {
  Rows rows(static_cast<std::size_t>(values.size()));
  std::iota(rows.begin(), rows.end(), Eigen::Index{0});
  std::nth_element(rows.begin(), rows.begin() + (count - 1), rows.end(), [&](Eigen::Index a, Eigen::Index b) {
    return values[a] != values[b] ? values[a] < values[b] : a < b;
  });
  rows.resize(static_cast<std::size_t>(count));
  return rows;
}

/// Some of the points, taken at random.
class RandomRows {
 public:
  explicit RandomRows(Eigen::Index points) : taken_(static_cast<std::size_t>(points)) {}
  /// Adds points of `random` that are not among the rows yet, until there are `count`, which is fewer than all.
  void grow(Eigen::Index count, std::mt19937_64& random) {
    while (size() < count) {
      const auto row = static_cast<std::size_t>(random() % taken_.size());
      if (taken_[row] != 0) continue;
      taken_[row] = 1;
      rows_.push_back(static_cast<Eigen::Index>(row));
    }
  }
  [[nodiscard]] const Rows& rows() const { return rows_; }
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(rows_.size()); }

 private:
  Rows rows_;
  std::vector<char> taken_;
};

/// The `count` points with the least sum of squares that a seeded search finds (FAST-LTS [Rousseeuw 2006]).
Rows trimmedStart(const Eigen::MatrixXd& design, const Eigen::VectorXd& y, Eigen::Index count) {
  std::mt19937_64 random(20140601);
  std::mt19937_64 more(20140602);  // apart: the rows a start begins with do not depend on how many the others needed
  const Eigen::Index points = design.rows();
  Rows best;
  double best_sum = std::numeric_limits<double>::infinity();
  for (int start = 0; start < (points > kManyPoints ? kStartsOfMany : kStarts); ++start) {
    RandomRows some(points);
    some.grow(design.cols(), random);
    SubsetFit fit = fitSubset(design, y, some.rows(), false);
    // With a column for each group of points, so few rarely have one of each group. By shares: a group may be rare.
    while (!fit.solved && some.size() < count) {
      some.grow(std::min(count, some.size() + std::max<Eigen::Index>(1, some.size() / 4)), more);
      fit = fitSubset(design, y, some.rows(), false);
    }
    Rows rows;
    for (int i = 0; i < kConcentrations && fit.solved; ++i) {
      rows = smallest(fit.residual, count);
      fit = fitSubset(design, y, rows, false);
    }
    if (!fit.solved) continue;
    rows = smallest(fit.residual, count);
    double sum = 0.0;
    for (const Eigen::Index row : rows) sum += fit.residual[row] * fit.residual[row];
    if (sum < best_sum) {
      best_sum = sum;
      best = rows;
    }
  }
  return best;
}

}  // namespace

std::vector<std::size_t> findOutliers(const Eigen::MatrixXd& design, const Eigen::VectorXd& y,
                                      const OutlierOptions& options) {
  const Eigen::Index points = design.rows(), unknowns = design.cols();
  if (points < unknowns + 3 || y.size() != points || !design.allFinite() || !y.allFinite()) return {};
  const double floor = std::max(options.least_sigma, kRounding * (y.maxCoeff() - y.minCoeff()));
  Rows good = trimmedStart(design, y, (points + unknowns + 1) / 2);
  const Eigen::Index stride = std::max<Eigen::Index>(1, points / 500);
  while (!good.empty()) {
    const SubsetFit fit = fitSubset(design, y, good, true);
    if (!fit.solved) return {};
    const double sigma = std::max({fit.sigma, floor, std::numeric_limits<double>::min()});
    const Eigen::VectorXd t = fit.residual.cwiseQuotient(fit.uncertainty * sigma);
    const auto size = static_cast<Eigen::Index>(good.size());
    if (size == points) return {};
    // One point too many among all of them is what the confidence allows (Bonferroni).
    const double doubt = (1.0 - options.confidence) / static_cast<double>(points);
    const double limit = studentQuantile(1.0 - doubt, static_cast<std::size_t>(size - unknowns));
    const Eigen::Index allowed = (t.array() < limit).count();
    if (allowed <= size) {
      std::vector<std::size_t> out;
      for (Eigen::Index i = 0; i < points; ++i) {
        if (t[i] >= limit) out.push_back(static_cast<std::size_t>(i));
      }
      return out;
    }
    good = smallest(t, std::min(allowed, size + stride));  // a stride must not carry the last of them along
  }
  return {};
}

}  // namespace fyd::calibration
