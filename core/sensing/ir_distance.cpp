#include "core/sensing/ir_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fyd::sensing {
namespace {

// 10·(79.0712 − 188.5623 v + …) of the thesis, in mm.
constexpr std::array<double, 6> kThesisCurve_mm = {790.712, -1885.623, 2208.604, -1338.297, 399.54, -46.327};

}  // namespace

IrDistance::IrDistance(std::span<const double> coefficients_mm, int lowest_code, int highest_code, IrCurveForm form)
    : lowest_code_(std::clamp(lowest_code, 0, kAdcCodes - 1)),
      highest_code_(std::clamp(highest_code, 0, kAdcCodes - 1)),
      form_(coefficients_mm.empty() ? IrCurveForm::polynomial : form) {
  const std::span<const double> curve =
      coefficients_mm.empty() ? std::span<const double>(kThesisCurve_mm) : coefficients_mm;
  for (const double c : curve) {
    if (!coefficients_.push(c)) break;
  }
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  if (form_ == IrCurveForm::inverse && coefficients_.size() != 3)
    coefficients_ = {.items = {kNan, kNan, kNan}, .count = 3};
}

double IrDistance::distance_mm(double volts) const {
  if (form_ == IrCurveForm::inverse) return coefficients_[0] / (volts + coefficients_[1]) + coefficients_[2];
  double d = 0.0;
  for (std::size_t i = coefficients_.size(); i-- > 0;) d = d * volts + coefficients_[i];
  return d;
}

IrReading IrDistance::read(double code) const {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  if (!(code >= lowest_code_ && code <= highest_code_)) return {.distance_mm = kNan};
  const double v = voltsFromCode(code);
  double d = 0.0;
  double slope = 0.0;
  if (form_ == IrCurveForm::inverse) {
    const double share = coefficients_[0] / (v + coefficients_[1]);
    slope = -share / (v + coefficients_[1]);
    d = share + coefficients_[2];
  } else {
    for (std::size_t i = coefficients_.size(); i-- > 0;) {
      slope = slope * v + d;
      d = d * v + coefficients_[i];
    }
  }
  if (!std::isfinite(d) || !std::isfinite(slope)) return {.distance_mm = kNan};
  return {.distance_mm = d, .slope_mm_per_V = std::abs(slope), .valid = true};
}

double IrDistance::voltsAt(double distance) const {
  double low = voltsFromCode(lowest_code_);
  double high = voltsFromCode(highest_code_);
  for (int i = 0; i < 48; ++i) {
    const double middle = 0.5 * (low + high);
    (distance_mm(middle) > distance ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace fyd::sensing
