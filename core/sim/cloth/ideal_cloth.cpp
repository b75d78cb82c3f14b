#include "core/sim/cloth/ideal_cloth.h"

#include <math.h>  // Boost 1.74 calls isnan without std::

#include <algorithm>
#include <cmath>
#include <vector>

#include <boost/math/interpolators/pchip.hpp>

namespace fyd::sim {
namespace {

constexpr double kRestAngle_deg = 20.0;
constexpr double kTurnaround_mm = 0.3;  // of indentation, from the mean line to the loop's edge

// End derivatives are the chords of the end segments (boost's default), so the straight extensions join smoothly.
const auto& measuredCurve() {
  static const boost::math::interpolators::pchip<std::vector<double>> curve({20.0, 45.0, 60.0, 90.0},
                                                                            {0.501, 0.550, 0.673, 0.715});
  return curve;
}

constexpr double kSlopeBelow = (0.550 - 0.501) / (45.0 - 20.0);
constexpr double kSlopeAbove = (0.715 - 0.673) / (90.0 - 60.0);

}  // namespace

double nominalStiffness(double angle_deg) {
  if (std::isnan(angle_deg)) angle_deg = kRestAngle_deg;
  const double angle = std::clamp(angle_deg, kNominalAngleMinimum_deg, kNominalAngleMaximum_deg);
  if (angle <= 20.0) return 0.501 + kSlopeBelow * (angle - 20.0);
  if (angle >= 90.0) return 0.715 + kSlopeAbove * (angle - 90.0);
  return measuredCurve()(angle);
}

double nominalAngle(double stiffness_N_per_mm) {
  if (std::isnan(stiffness_N_per_mm)) return kRestAngle_deg;
  double low = kNominalAngleMinimum_deg;
  double high = kNominalAngleMaximum_deg;
  if (stiffness_N_per_mm <= nominalStiffness(low)) return low;
  if (stiffness_N_per_mm >= nominalStiffness(high)) return high;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (nominalStiffness(middle) < stiffness_N_per_mm ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

IdealCloth::IdealCloth(double stiffness_scale, double hysteresis) : scale_(stiffness_scale), hysteresis_(hysteresis) {}

double spotRadius_mm(double force_N) { return force_N > 0.0 ? 3.5 + 2.5 * std::cbrt(force_N) : 0.0; }

double IdealCloth::press(double angle_deg, double indentation_mm) {
  const double factor = loop(indentation_mm);
  return indentation_mm > 0.0 ? stiffness(angle_deg) * indentation_mm * factor : 0.0;
}

double IdealCloth::loop(double indentation_mm) {
  if (!(indentation_mm > 0.0)) {  // NaN too
    direction_ = 0.0;
    last_mm_ = 0.0;
    return 1.0;
  }
  direction_ = std::clamp(direction_ + (indentation_mm - last_mm_) / kTurnaround_mm, -1.0, 1.0);
  last_mm_ = indentation_mm;
  return 1.0 + hysteresis_ * direction_;
}

}  // namespace fyd::sim
