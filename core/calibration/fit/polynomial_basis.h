// Polynomials on a scaled basis: Chebyshev polynomials of t = (x − middle)/half, so that t runs from −1 to 1 over the
// data whatever their unit and offset. Powers of raw counts or volts would lose half the digits.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fyd::calibration {

class PolynomialBasis {
 public:
  /// Over lowest…highest, the span of the data; lowest < highest.
  PolynomialBasis(double lowest, double highest, std::size_t degree);
  /// Over the data's own span.
  PolynomialBasis(std::span<const double> x, std::size_t degree);

  [[nodiscard]] std::size_t degree() const { return degree_; }
  /// T₀…Tₙ at each x, one row per x.
  [[nodiscard]] Eigen::MatrixXd design(std::span<const double> x) const;

  /// The matrix that turns coefficients on this basis into those of 1, x, x², …
  [[nodiscard]] Eigen::MatrixXd toPowers() const;

 private:
  double middle_ = 0.0;
  double half_ = 1.0;
  std::size_t degree_ = 0;
};

}  // namespace fyd::calibration
