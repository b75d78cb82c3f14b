#include "core/calibration/fit/least_squares.h"

#include <cmath>
#include <limits>

#include <Eigen/QR>
#include <Eigen/SVD>

namespace fyd::calibration {

double LinearFit::standardError(Eigen::Index i) const { return std::sqrt(covariance(i, i)); }

Result<LinearFit> fitLinear(const Eigen::MatrixXd& design, const Eigen::VectorXd& y, const Eigen::VectorXd& weights) {
  const Eigen::Index rows = design.rows(), columns = design.cols();
  if (rows < columns || columns == 0)
    return fail("{} points for {} unknowns; expected at least as many", rows, columns);
  if (y.size() != rows || (weights.size() != 0 && weights.size() != rows)) {
    return fail("{} values and {} weights for {} points", y.size(), weights.size(), rows);
  }
  if (!design.allFinite() || !y.allFinite() || !weights.allFinite()) return fail("a value is not finite");

  Eigen::MatrixXd scaled = design;
  Eigen::VectorXd target = y;
  if (weights.size() != 0) {
    if (weights.minCoeff() < 0) return fail("a weight is negative");
    scaled.array().colwise() *= weights.array().sqrt();
    target.array() *= weights.array().sqrt();
  }
  Eigen::VectorXd length(columns);
  for (Eigen::Index j = 0; j < columns; ++j) {
    length[j] = scaled.col(j).stableNorm();
    if (!(length[j] > 0) || !std::isfinite(length[j])) return fail("an unknown that no point tells anything of");
    scaled.col(j) /= length[j];
  }
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(scaled);
  const Eigen::MatrixXd r = qr.matrixQR().topRows(columns).triangularView<Eigen::Upper>();
  // R is square: without the preconditioners for other shapes, which would double the compile time.
  const Eigen::VectorXd singular = Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner>(r).singularValues();

  LinearFit fit;
  fit.condition_number =
      singular[columns - 1] > 0 ? singular[0] / singular[columns - 1] : std::numeric_limits<double>::infinity();
  if (!(fit.condition_number <= kSolvableCondition)) {
    return fail("the points do not tell the unknowns apart (condition number {:.3g})", fit.condition_number);
  }
  const Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(rows, columns);
  const auto triangle = r.triangularView<Eigen::Upper>();
  const Eigen::VectorXd solved = triangle.solve(q.transpose() * target);
  const Eigen::MatrixXd inverse = triangle.solve(Eigen::MatrixXd::Identity(columns, columns));

  fit.coefficients = solved.cwiseQuotient(length);
  fit.residuals = y - design * fit.coefficients;
  fit.leverage = q.rowwise().squaredNorm();
  fit.degrees_of_freedom = static_cast<std::size_t>(rows - columns);
  const double weighted = (target - scaled * solved).stableNorm();
  fit.sigma = fit.degrees_of_freedom > 0 ? weighted / std::sqrt(static_cast<double>(fit.degrees_of_freedom))
                                         : std::numeric_limits<double>::quiet_NaN();
  const Eigen::MatrixXd root = length.cwiseInverse().asDiagonal() * inverse * fit.sigma;
  fit.covariance = root * root.transpose();
  fit.rmse = fit.residuals.stableNorm() / std::sqrt(static_cast<double>(rows));
  fit.max_residual = fit.residuals.cwiseAbs().maxCoeff();
  if (!fit.coefficients.allFinite() || !std::isfinite(fit.rmse))
    return fail("the values are too large to compute with");
  return fit;
}

LinearImage imageOf(const LinearFit& fit, const Eigen::MatrixXd& map) {
  return {map * fit.coefficients, map * fit.covariance * map.transpose()};
}

}  // namespace fyd::calibration
