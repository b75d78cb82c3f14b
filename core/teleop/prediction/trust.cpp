#include "core/teleop/prediction/trust.h"

#include <algorithm>

#include "core/base/portable_math.h"

namespace fyd::teleop {
namespace {

constexpr double kTrustForgetting = 0.99;    // per evaluated tick
constexpr double kCoefficientScale = 1.2;    // factor on the regression coefficient
constexpr double kInitialWeight = 5.0;       // of the prior, in predictions
constexpr double kFullHorizon_s = 0.220;     // up to this horizon the prior coefficient is not reduced
constexpr double kRandomWalkRatio = 2.0;     // squared second differences over first ones on a random walk
constexpr double kTremor_mm2 = 0.0009;       // (0.03 mm)²: tremor of a hand at rest, unpredictable
constexpr double kInitialTremor_mm2 = 0.04;  // (0.2 mm)²: the same, for initialFactor

double inner(const Position& a, const Position& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace

void Trust::addDifferences(double first_mm2, double second_mm2) {
  first_mm2_ += first_mm2;
  second_mm2_ += second_mm2;
}

void Trust::addOutcome(const Position& predicted_mm, const Position& true_mm) {
  predicted_mm2_ = predicted_mm2_ * kTrustForgetting + inner(predicted_mm, predicted_mm);
  product_mm2_ = product_mm2_ * kTrustForgetting + inner(predicted_mm, true_mm);
}

double Trust::smoothness() const {
  return first_mm2_ > 0.0 ? std::clamp(1.0 - second_mm2_ / (kRandomWalkRatio * first_mm2_), 0.0, 1.0) : 1.0;
}

double Trust::initialFactor(const Position& predicted_mm) const {
  const double squares = inner(predicted_mm, predicted_mm);
  return smoothness() * squares / (squares + kInitialTremor_mm2);
}

double Trust::factor(double typical_mm2, double initial_share, double age_s) const {
  const double prior_mm2 = kInitialWeight * initial_share * typical_mm2;
  const double prior_coefficient = smoothness() * math::square(age_s > kFullHorizon_s ? kFullHorizon_s / age_s : 1.0) *
                                   typical_mm2 / (typical_mm2 + kTremor_mm2);
  return std::clamp(
      kCoefficientScale * (product_mm2_ + prior_coefficient * prior_mm2) / (predicted_mm2_ + prior_mm2 + kTremor_mm2),
      0.0, 1.0);
}

}  // namespace fyd::teleop
