#include "core/calibration/camera_calibration.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/calibration/fit/cross_validation.h"
#include "core/calibration/fit/least_squares.h"
#include "core/calibration/fit/outliers.h"

namespace fyd::calibration {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kLineCondition = 30.0;  // of the scaled plane design: above it the points lie on a line
constexpr double kLeastTurn_deg = 0.1;
constexpr double kSureOfCamera = 3.0;
constexpr double kLargest_px = 1e5, kLargest_mm = 1e4;
constexpr double kLeastNoise_mm = 0.02;
constexpr double kDeepest_mm = 25.0;
constexpr std::size_t kFewestForHeight = 6;
constexpr double kUsualHeight_mm = 100.0, kLowestHeight_mm = 30.0, kHighestHeight_mm = 10'000.0;

double spanOf(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

double wrapped(double degrees) { return std::remainder(degrees, 360.0); }

/// One axis: mm = slope·px + offset, in the frame turned back by `turn`.
struct Axis {
  double slope = 0.0, offset = 0.0;
};
struct Axes {
  Axis x, y;
};

struct Frame {
  Eigen::VectorXd u, v, x, y;  // pixels less their mean, millimetres in the turned frame
  double mean_u = 0.0, mean_v = 0.0;
};

Frame frameOf(const CameraSamples& s, double turn_deg) {
  const auto asVector = [](const std::vector<double>& values) {
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
  };
  Frame f{asVector(s.x_px), asVector(s.y_px), {}, {}};
  const Eigen::VectorXd x = asVector(s.x_mm), y = asVector(s.y_mm);
  const double c = std::cos(turn_deg / kDegrees), n = std::sin(turn_deg / kDegrees);
  f.x = c * x + n * y;
  f.y = -n * x + c * y;
  f.mean_u = f.u.mean();
  f.mean_v = f.v.mean();
  f.u.array() -= f.mean_u;
  f.v.array() -= f.mean_v;
  return f;
}

Eigen::MatrixXd lineDesign(const Eigen::VectorXd& px, const std::vector<std::size_t>& rows) {
  Eigen::MatrixXd out(static_cast<Eigen::Index>(rows.size()), 2);
  for (std::size_t i = 0; i < rows.size(); ++i)
    out.row(static_cast<Eigen::Index>(i)) << px[static_cast<Eigen::Index>(rows[i])], 1.0;
  return out;
}

Eigen::VectorXd part(const Eigen::VectorXd& values, const std::vector<std::size_t>& rows) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    out[static_cast<Eigen::Index>(i)] = values[static_cast<Eigen::Index>(rows[i])];
  return out;
}

struct BothFits {
  LinearFit x, y;
};
Result<BothFits> fitAxes(const Frame& f, const std::vector<std::size_t>& rows) {
  auto x = fitLinear(lineDesign(f.u, rows), part(f.x, rows));
  if (!x) return tl::unexpected(x.error());
  auto y = fitLinear(lineDesign(f.v, rows), part(f.y, rows));
  if (!y) return tl::unexpected(y.error());
  return BothFits{std::move(*x), std::move(*y)};
}

/// Turn, shear and mirror from the full affine fit: [x; y] = M [u; v] + t with M = R(rotation)·diag(±sx, −sy).
bool findTurn(CameraCalibration& out, const Frame& f) {
  Eigen::MatrixXd design(f.u.size(), 3);
  design << f.u, f.v, Eigen::VectorXd::Ones(f.u.size());
  const auto x = fitLinear(design, f.x), y = fitLinear(design, f.y);
  CalibrationResult& result = out.result;
  if (!x || !y || x->condition_number > kLineCondition) {
    refuse(result,
           say("the points lie on one line in the picture: add points off that line, at the corners of the cloth"));
    return false;
  }
  result.condition_number = x->condition_number;
  const double m00 = x->coefficients[0], m01 = x->coefficients[1], m10 = y->coefficients[0], m11 = y->coefficients[1];
  const double determinant = m00 * m11 - m01 * m10;
  const double sx = std::hypot(m00, m10), sy = std::hypot(m01, m11);
  if (!(std::abs(determinant) > 1e-6 * sx * sy) || !(sx > 0) || !(sy > 0)) {
    refuse(result, say("the millimetres lie on one line though the pixels do not: check the columns x_mm and y_mm"));
    return false;
  }
  out.mirrored = determinant > 0;
  const double sign = out.mirrored ? -1.0 : 1.0;
  const double from_x = std::atan2(sign * m10, sign * m00) * kDegrees;
  const double from_y = std::atan2(m01, -m11) * kDegrees;
  out.shear_deg = wrapped(from_y - from_x);
  out.rotation_deg = wrapped(from_x + 0.5 * out.shear_deg);
  // Each column's direction is uncertain by the error across it; both count half.
  const double error_x = std::max(x->standardError(0), y->standardError(0)) / sx;
  const double error_y = std::max(x->standardError(1), y->standardError(1)) / sy;
  out.rotation_error_deg = 0.5 * std::hypot(error_x, error_y) * kDegrees;
  return true;
}

/// The points projected from the lens onto the untouched cloth's plane: H/(H − δ) as far from the axis.
CameraSamples onThePlane(const CameraSamples& s, double one_over_height) {
  CameraSamples out = s;
  for (std::size_t i = 0; i < s.depth_mm.size(); ++i) {
    const double nearer = 1.0 - s.depth_mm[i] * one_over_height;
    out.x_mm[i] /= nearer;
    out.y_mm[i] /= nearer;
  }
  return out;
}

struct Height {
  double mm = kUnknown;
  double error_mm = kUnknown;
};

/// The height at which the points agree best with one affine map; NaN when they do not tell it.
Height findHeight(const CameraSamples& s) {
  const auto residualsAt = [&s](double one_over_height) -> Eigen::VectorXd {
    const Frame f = frameOf(onThePlane(s, one_over_height), 0.0);
    Eigen::MatrixXd design(f.u.size(), 3);
    design << f.u, f.v, Eigen::VectorXd::Ones(f.u.size());
    const auto x = fitLinear(design, f.x), y = fitLinear(design, f.y);
    if (!x || !y) return {};
    Eigen::VectorXd out(2 * f.u.size());
    out << x->residuals, y->residuals;
    return out;
  };
  constexpr double kStep = 1e-3;  // of 1/H
  const double freedom = 2.0 * static_cast<double>(s.x_px.size()) - 7.0;
  double at = 1.0 / kUsualHeight_mm, sigma = kUnknown;
  for (int round = 0; round < 20; ++round) {
    const Eigen::VectorXd here = residualsAt(at), above = residualsAt((1.0 + kStep) * at),
                          below = residualsAt((1.0 - kStep) * at);
    if (here.size() == 0 || above.size() == 0 || below.size() == 0) return {};
    const Eigen::VectorXd slope = (above - below) / (2.0 * kStep);  // mm for the whole of 1/H
    const double information = slope.squaredNorm();
    const double noise_mm = std::max(std::sqrt(here.squaredNorm() / freedom), kLeastNoise_mm);
    sigma = noise_mm / std::sqrt(information);
    if (!std::isfinite(sigma) || sigma > 1.0) return {};
    const double step = std::clamp(-slope.dot(here) / information, -0.5, 0.5);
    at = std::clamp(at * (1.0 + step), 1.0 / kHighestHeight_mm, 1.0 / kLowestHeight_mm);
    if (std::abs(step) < 1e-9) break;
  }
  return {.mm = 1.0 / at, .error_mm = sigma / at};
}

/// @return whether the points tell the height well enough, or need not
bool findHeight(CalibrationResult& result, const CameraSamples& s, const CalibrationParameters& p, Height& height) {
  const auto deeper = [](double depth_mm) { return depth_mm > 0.0; };
  if (std::none_of(s.depth_mm.begin(), s.depth_mm.end(), deeper)) return true;
  if (s.x_px.size() < kFewestForHeight) {
    refuseTooFew(result,
                 say("{} points; the camera's height takes at least {}: at the cloth's corners, some on the untouched "
                     "cloth and some pressed down",
                     s.x_px.size(), kFewestForHeight),
                 "calibration.camera_height_percent");
    return false;
  }
  height = findHeight(s);
  const double percent = 100.0 * height.error_mm / height.mm;
  const bool inside = height.mm > kLowestHeight_mm && height.mm < kHighestHeight_mm;
  if (percent <= p.camera_height_percent && inside) return true;
  const Message known = std::isfinite(percent) && inside
                            ? say("the camera's height is known only to {:.0f} %; expected at most {:g} %", percent,
                                  p.camera_height_percent)
                            : say("the depths do not tell the camera's height");
  refuse(result,
         say("{}: take points at the cloth's corners, far from its middle, some on the untouched cloth and "
             "some pressed down as deep as you can",
             known),
         "calibration.camera_height_percent");
  return false;
}

}  // namespace

CameraCalibration calibrateCamera(const CameraSamples& samples, const CalibrationParameters& p) {
  CameraSamples s = samples;
  CameraCalibration out;
  CalibrationResult& result = out.result;
  result = {.procedure = "camera",
            .curve = say("a line for each axis"),
            .unit = "mm",
            .points = s.x_px.size(),
            .samples = {{"x_px", "px", s.x_px}, {"y_px", "px", s.y_px}, {"x_mm", "mm", s.x_mm}, {"y_mm", "mm", s.y_mm}},
            .valid_unit = "px"};
  if (!s.depth_mm.empty()) result.samples.push_back({"depth_mm", "mm", s.depth_mm});
  if (s.y_px.size() != s.x_px.size() || s.x_mm.size() != s.x_px.size() || s.y_mm.size() != s.x_px.size() ||
      (!s.depth_mm.empty() && s.depth_mm.size() != s.x_px.size())) {
    refuse(result, say("the columns differ in length"));
    return out;
  }
  bool good = checkColumn(result, "x_px", s.x_px, -kLargest_px, kLargest_px);
  good = checkColumn(result, "y_px", s.y_px, -kLargest_px, kLargest_px) && good;
  good = checkColumn(result, "x_mm", s.x_mm, -kLargest_mm, kLargest_mm) && good;
  good = checkColumn(result, "depth_mm", s.depth_mm, 0.0, kDeepest_mm) && good;
  if (!checkColumn(result, "y_mm", s.y_mm, -kLargest_mm, kLargest_mm) || !good) return out;

  std::vector<std::size_t> different;  // points that repeat an earlier one add no information
  for (std::size_t i = 0; i < s.x_px.size() && different.size() < static_cast<std::size_t>(p.camera_fewest_points);
       ++i) {
    const bool seen = std::any_of(different.begin(), different.end(), [&](std::size_t j) {
      return std::hypot(s.x_px[i] - s.x_px[j], s.y_px[i] - s.y_px[j]) < 1.0;
    });
    if (!seen) different.push_back(i);
  }
  if (different.size() < static_cast<std::size_t>(p.camera_fewest_points)) {
    refuseTooFew(result,
                 say("{} different points; expected at least {}: add points, best at the corners of "
                     "the cloth",
                     different.size(), p.camera_fewest_points),
                 "calibration.camera_fewest_points");
    return out;
  }
  for (const auto& [name, values] : {std::pair{"x_px", &s.x_px}, std::pair{"y_px", &s.y_px}}) {
    if (spanOf(*values) >= p.camera_least_span_px) continue;
    refuseTooFew(result,
                 say("{} spans only {:.3g} px; expected at least {:g}: add points farther {}", name, spanOf(*values),
                     p.camera_least_span_px, *name == 'x' ? say("left and right") : say("up and down")),
                 "calibration.camera_least_span_px");
    return out;
  }
  if (!findTurn(out, frameOf(s, 0.0))) return out;
  Height height;
  if (!findHeight(result, s, p, height)) return out;
  if (std::isfinite(height.mm)) {
    s = onThePlane(s, 1.0 / height.mm);
    if (!findTurn(out, frameOf(s, 0.0))) return out;
  }
  const double half_turn = std::abs(out.rotation_deg) > 90.0 ? 180.0 : 0.0;
  const double turn = wrapped(out.rotation_deg - half_turn);
  out.rotated = std::abs(turn) > std::max(kLeastTurn_deg, kSureOfCamera * out.rotation_error_deg);
  const Frame frame = frameOf(s, out.rotated ? turn : 0.0);

  std::vector<std::size_t> rows(s.x_px.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
  const auto fits = fitAxes(frame, rows);
  if (!fits) {
    refuse(result, fits.error().message);
    return out;
  }
  const auto& [x, y] = *fits;
  const Axes axes{{x.coefficients[0], x.coefficients[1] - x.coefficients[0] * frame.mean_u},
                  {y.coefficients[0], y.coefficients[1] - y.coefficients[0] * frame.mean_v}};
  const auto offsetError = [](const LinearFit& fit, double mean) {
    return std::hypot(fit.standardError(1), mean * fit.standardError(0));
  };
  result.coefficients = {{"scale_x", "mm/px", axes.x.slope, x.standardError(0)},
                         {"scale_y", "mm/px", axes.y.slope, y.standardError(0)},
                         {"offset_x", "mm", axes.x.offset, offsetError(x, frame.mean_u)},
                         {"offset_y", "mm", axes.y.offset, offsetError(y, frame.mean_v)}};
  if (std::isfinite(height.mm)) result.coefficients.push_back({"camera_height", "mm", height.mm, height.error_mm});
  out.residual_x_mm.assign(x.residuals.begin(), x.residuals.end());
  out.residual_y_mm.assign(y.residuals.begin(), y.residuals.end());
  for (std::size_t i = 0; i < rows.size(); ++i)
    result.residuals.push_back(std::hypot(out.residual_x_mm[i], out.residual_y_mm[i]));
  result.rmse = rootMeanSquare(result.residuals);
  result.max_residual = *std::max_element(result.residuals.begin(), result.residuals.end());
  result.valid_from = *std::min_element(s.x_px.begin(), s.x_px.end());
  result.valid_to = *std::max_element(s.x_px.begin(), s.x_px.end());
  for (const auto& outliers : {findOutliers(lineDesign(frame.u, rows), frame.x, {.least_sigma = kLeastNoise_mm}),
                               findOutliers(lineDesign(frame.v, rows), frame.y, {.least_sigma = kLeastNoise_mm})}) {
    result.outliers.insert(result.outliers.end(), outliers.begin(), outliers.end());
  }
  std::sort(result.outliers.begin(), result.outliers.end());
  result.outliers.erase(std::unique(result.outliers.begin(), result.outliers.end()), result.outliers.end());

  const auto folds = foldsByOrder(rows.size());
  const auto held = predictHeldOut(
      folds, [&](const std::vector<std::size_t>& learn) { return fitAxes(frame, learn); },
      [&](const BothFits& fit, std::size_t row) {
        const auto i = static_cast<Eigen::Index>(row);
        return std::hypot(frame.x[i] - fit.x.coefficients[0] * frame.u[i] - fit.x.coefficients[1],
                          frame.y[i] - fit.y.coefficients[0] * frame.v[i] - fit.y.coefficients[1]);
      });
  result.held_out_rmse = rootMeanSquare(held);
  if (std::abs(out.shear_deg) > 1.0) {
    result.notes.push_back(
        say("the axes stand {:.1f} deg from a right angle: the camera looks at the cloth aslant", out.shear_deg));
  }
  if (out.mirrored) {
    result.notes.push_back(
        say("picture and target are mirror images; if the camera shows no mirrored picture, the signs of "
            "y_mm are wrong: it grows to the back, upward in the picture"));
  }
  if (!(result.held_out_rmse <= p.camera_held_out_mm)) {
    refuse(result,
           say("held-out error {}; expected at most {:g} mm: {}", errorWithUnit(result.held_out_rmse, "mm"),
               p.camera_held_out_mm,
               !hasFewOutliers(result) ? say("lay the target flat and set the camera square to it")
                                       : say("measure the outliers again")),
           "calibration.camera_held_out_mm");
    return out;
  }
  const double rotation = out.rotated ? out.rotation_deg : half_turn;
  result.changes = {{"sensing.finger_scale_x_mm_per_px", fmt::format("{}", std::abs(axes.x.slope))},
                    {"sensing.finger_scale_y_mm_per_px", fmt::format("{}", std::abs(axes.y.slope))},
                    {"sensing.finger_centre_x_px", fmt::format("{}", -axes.x.offset / axes.x.slope)},
                    {"sensing.finger_centre_y_px", fmt::format("{}", -axes.y.offset / axes.y.slope)},
                    {"sensing.finger_rotation_deg", fmt::format("{}", rotation)},
                    {"sensing.finger_mirror", out.mirrored ? "true" : "false"}};
  if (std::isfinite(height.mm))
    result.changes.push_back({"sensing.camera_height_mm", fmt::format("{:.6g}", height.mm)});
  result.verdict = {.accepted = true,
                    .reason = say("held-out error {} of at most {:g} mm", errorWithUnit(result.held_out_rmse, "mm"),
                                  p.camera_held_out_mm),
                    .threshold = "calibration.camera_held_out_mm"};
  return out;
}

}  // namespace fyd::calibration
