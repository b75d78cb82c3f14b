#include "core/teleop/prediction/trust.h"

#include <algorithm>

#include "core/base/portable_math.h"

namespace fyd::teleop {
namespace {

constexpr double kMemory = 0.99;          // per settled tick
constexpr double kDoubt = 1.2;            // factor on the regression coefficient
constexpr double kBegin = 5.0;            // weight of the initial value, in predictions
constexpr double kSure_s = 0.220;         // horizon up to which the initial share is not reduced
constexpr double kAimless = 2.0;          // second differences by first ones: a random walk
constexpr double kNoise_mm2 = 0.0009;     // (0.03 mm)²: unpredictable tremor of a hand at rest
constexpr double kFirstNoise_mm2 = 0.04;  // (0.2 mm)²: the same for the initial share

double dot(const Position& a, const Position& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace

void Trust::watch(double step_mm2, double bend_mm2) {
  steps_mm2_ += step_mm2;
  bends_mm2_ += bend_mm2;
}

void Trust::settle(const Position& predicted_by_mm, const Position& true_by_mm) {
  by_mm2_ = by_mm2_ * kMemory + dot(predicted_by_mm, predicted_by_mm);
  along_mm2_ = along_mm2_ * kMemory + dot(predicted_by_mm, true_by_mm);
}

double Trust::smoothness() const {
  return steps_mm2_ > 0.0 ? std::clamp(1.0 - bends_mm2_ / (kAimless * steps_mm2_), 0.0, 1.0) : 1.0;
}

double Trust::first(const Position& by_mm) const {
  const double squares = dot(by_mm, by_mm);
  return smoothness() * squares / (squares + kFirstNoise_mm2);
}

double Trust::now(double usual_mm2, double youth, double age_s) const {
  const double before = kBegin * youth * usual_mm2;
  const double sure =
      smoothness() * math::square(age_s > kSure_s ? kSure_s / age_s : 1.0) * usual_mm2 / (usual_mm2 + kNoise_mm2);
  return std::clamp(kDoubt * (along_mm2_ + sure * before) / (by_mm2_ + before + kNoise_mm2), 0.0, 1.0);
}

}  // namespace fyd::teleop
