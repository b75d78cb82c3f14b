#include "core/control/static_law.h"

#include <algorithm>
#include <cmath>

namespace fyd::control {
namespace {

// θ = A k² + B k + C [thesis §4.1.4] and θ = M k + N.
constexpr double kA = 314.5, kB = -107.0, kC = -0.3552;
constexpr double kM = 204.6, kN = -23.6;
// The range the thesis states for the device; both printed laws rise over all of it.
constexpr double kPrintedMinimum_N_per_mm = 0.3;
constexpr double kPrintedMaximum_N_per_mm = 0.9;

/// Tangent at an end from its two slopes (three-point formula), clamped so that the curve stays monotone.
double endTangent(double near_width, double far_width, double near_slope, double far_slope) {
  const double tangent =
      ((2 * near_width + far_width) * near_slope - near_width * far_slope) / (near_width + far_width);
  return std::clamp(tangent, 0.0, 3 * near_slope);
}

}  // namespace

StaticLaw::StaticLaw() : StaticLaw(ControlParameters{}) {}

StaticLaw::StaticLaw(const ControlParameters& parameters) {
  if (!configure(parameters.law, parameters.law_angle_deg, parameters.law_stiffness_N_per_mm)) {
    const ControlParameters fallback;
    configure(parameters.law, fallback.law_angle_deg, fallback.law_stiffness_N_per_mm);
  }
}

bool StaticLaw::configure(StaticLawKind kind, const ParameterList& angle_deg, const ParameterList& stiffness) {
  const std::size_t count = angle_deg.size();
  if (count < 2 || stiffness.size() != count) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(angle_deg[i]) || !std::isfinite(stiffness[i]) || !(stiffness[i] > 0)) return false;
    if (i > 0 && !(angle_deg[i] > angle_deg[i - 1] && stiffness[i] > stiffness[i - 1])) return false;
  }
  kind_ = kind;
  count_ = count;
  std::copy_n(angle_deg.begin(), count, theta_.begin());
  std::copy_n(stiffness.begin(), count, k_.begin());

  const auto width = [this](std::size_t i) { return theta_[i + 1] - theta_[i]; };
  const auto slope = [this, &width](std::size_t i) { return (k_[i + 1] - k_[i]) / width(i); };
  if (count == 2) {
    tangent_[0] = tangent_[1] = slope(0);
  } else {
    for (std::size_t i = 1; i + 1 < count; ++i) {
      const double before = 2 * width(i) + width(i - 1), after = width(i) + 2 * width(i - 1);
      tangent_[i] = (before + after) / (before / slope(i - 1) + after / slope(i));
    }
    tangent_[0] = endTangent(width(0), width(1), slope(0), slope(1));
    tangent_[count - 1] = endTangent(width(count - 2), width(count - 3), slope(count - 2), slope(count - 3));
  }
  takeWholeDomain();
  return true;
}

void StaticLaw::takeWholeDomain() {
  if (kind_ == StaticLawKind::interpolated) {
    minimum_k_ = k_[0];
    maximum_k_ = k_[count_ - 1];
    whole_minimum_deg_ = theta_[0];
    whole_maximum_deg_ = theta_[count_ - 1];
  } else {
    minimum_k_ = kPrintedMinimum_N_per_mm;
    maximum_k_ = kPrintedMaximum_N_per_mm;
    whole_minimum_deg_ = angleAt(minimum_k_);
    whole_maximum_deg_ = angleAt(maximum_k_);
  }
  minimum_deg_ = whole_minimum_deg_;
  maximum_deg_ = whole_maximum_deg_;
}

void StaticLaw::limitTravel(double minimum_deg, double maximum_deg) {
  takeWholeDomain();
  if (!(minimum_deg <= maximum_deg)) return;
  const double low = std::clamp(minimum_deg, minimum_deg_, maximum_deg_);
  const double high = std::clamp(maximum_deg, minimum_deg_, maximum_deg_);
  const double low_k = stiffnessAt(low), high_k = stiffnessAt(high);
  // Where the law does not reach into the travel, both are its nearest end, and the travel's own end takes its place.
  minimum_deg_ = std::clamp(low, minimum_deg, maximum_deg);
  maximum_deg_ = std::clamp(high, minimum_deg, maximum_deg);
  minimum_k_ = low_k;
  maximum_k_ = high_k;
}

LawValue StaticLaw::angle_deg(double stiffness) const {
  if (!(stiffness > minimum_k_)) return {minimum_deg_, stiffness != minimum_k_};
  if (stiffness >= maximum_k_) return {maximum_deg_, stiffness != maximum_k_};
  return {std::clamp(angleAt(stiffness), minimum_deg_, maximum_deg_), false};
}

LawValue StaticLaw::stiffness_N_per_mm(double angle) const {
  if (!(angle > minimum_deg_)) return {minimum_k_, angle != minimum_deg_};
  if (angle >= maximum_deg_) return {maximum_k_, angle != maximum_deg_};
  return {std::clamp(stiffnessAt(angle), minimum_k_, maximum_k_), false};
}

double StaticLaw::slope_N_per_mm_deg(double angle) const {
  const double limited = std::isnan(angle) ? minimum_deg_ : std::clamp(angle, minimum_deg_, maximum_deg_);
  const double inside =
      std::clamp(limited, whole_minimum_deg_, whole_maximum_deg_);  // the travel may lie beside the law
  if (kind_ == StaticLawKind::thesis) return 1.0 / (2 * kA * stiffnessAt(inside) + kB);
  if (kind_ == StaticLawKind::thesis_linear) return 1.0 / kM;
  const std::size_t i = segmentOf(theta_, inside);
  const double h = theta_[i + 1] - theta_[i];
  const double t = (inside - theta_[i]) / h;
  return 6 * t * (1 - t) * (k_[i + 1] - k_[i]) / h + (1 - t) * (1 - 3 * t) * tangent_[i] +
         t * (3 * t - 2) * tangent_[i + 1];
}

std::size_t StaticLaw::segmentOf(const std::array<double, kParameterListCapacity>& knots, double x) const {
  std::size_t i = 0;
  while (i + 2 < count_ && x >= knots[i + 1]) ++i;
  return i;
}

double StaticLaw::cubic(std::size_t i, double angle) const {
  const double h = theta_[i + 1] - theta_[i];
  const double t = (angle - theta_[i]) / h;
  const double s = 1 - t;
  return s * s * ((1 + 2 * t) * k_[i] + t * h * tangent_[i]) +
         t * t * ((1 + 2 * s) * k_[i + 1] - s * h * tangent_[i + 1]);
}

double StaticLaw::stiffnessAt(double angle) const {
  switch (kind_) {
    case StaticLawKind::thesis: return (-kB + std::sqrt(kB * kB - 4 * kA * (kC - angle))) / (2 * kA);
    case StaticLawKind::thesis_linear: return (angle - kN) / kM;
    case StaticLawKind::interpolated: break;
  }
  return cubic(segmentOf(theta_, angle), angle);
}

double StaticLaw::angleAt(double stiffness) const {
  switch (kind_) {
    case StaticLawKind::thesis: return (kA * stiffness + kB) * stiffness + kC;
    case StaticLawKind::thesis_linear: return kM * stiffness + kN;
    case StaticLawKind::interpolated: break;
  }
  const std::size_t i = segmentOf(k_, stiffness);
  double low = theta_[i], high = theta_[i + 1];
  if (stiffness >= k_[i + 1]) return high;
  // Halving 180° 48 times leaves less than 1e−12°; the slope may be 0 at a point, so no Newton here.
  for (int n = 0; n < 48; ++n) {
    const double middle = 0.5 * (low + high);
    (cubic(i, middle) < stiffness ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace fyd::control
