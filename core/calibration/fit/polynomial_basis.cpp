#include "core/calibration/fit/polynomial_basis.h"

#include <algorithm>

namespace fyd::calibration {

PolynomialBasis::PolynomialBasis(double lowest, double highest, std::size_t degree)
    : middle_(lowest + 0.5 * (highest - lowest)), half_(0.5 * (highest - lowest)), degree_(degree) {}

PolynomialBasis::PolynomialBasis(std::span<const double> x, std::size_t degree)
    : PolynomialBasis(*std::min_element(x.begin(), x.end()), *std::max_element(x.begin(), x.end()), degree) {}

Eigen::MatrixXd PolynomialBasis::design(std::span<const double> x) const {
  Eigen::MatrixXd out(static_cast<Eigen::Index>(x.size()), static_cast<Eigen::Index>(degree_) + 1);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double t = (x[i] - middle_) / half_;
    out(row, 0) = 1.0;
    if (degree_ > 0) out(row, 1) = t;
    for (Eigen::Index j = 2; j < out.cols(); ++j) out(row, j) = 2.0 * t * out(row, j - 1) - out(row, j - 2);
  }
  return out;
}

Eigen::MatrixXd PolynomialBasis::toPowers() const {
  const Eigen::Index count = static_cast<Eigen::Index>(degree_) + 1;
  Eigen::MatrixXd powers = Eigen::MatrixXd::Zero(count, count);  // column j: Tⱼ as powers of x
  const double shift = -middle_ / half_;
  powers(0, 0) = 1.0;
  const auto timesT = [&](Eigen::Index from) {
    Eigen::VectorXd product = shift * powers.col(from);
    for (Eigen::Index i = 1; i < count; ++i) product[i] += powers(i - 1, from) / half_;
    return product;
  };
  if (count > 1) powers.col(1) = timesT(0);
  for (Eigen::Index j = 2; j < count; ++j) powers.col(j) = 2.0 * timesT(j - 1) - powers.col(j - 2);
  return powers;
}

}  // namespace fyd::calibration
