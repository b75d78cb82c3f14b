#include "core/teleop/prediction/horizons.h"

#include <algorithm>
#include <cmath>

namespace fyd::teleop {
namespace {

constexpr double kSameStepTolerance = 0.05;          // a first spacing within this share of kLeastStep_s counts as that
constexpr double kShorterSpacing = 0.7;              // in Δ
constexpr int kShorterCount = 3, kLongerCount = 12;  // spacings in a row that change Δ
constexpr int kMostSteps = 96;                       // longest horizon, in Δ
constexpr int kChoiceInterval = 16;                  // messages between two choices of the nodes

}  // namespace

bool Horizons::updateSpacing(double spacing_s) {
  double new_step_s = std::max(spacing_s, kLeastStep_s);
  if (step_s_ == 0.0) {
    if (std::abs(new_step_s - kLeastStep_s) < kSameStepTolerance * kLeastStep_s) new_step_s = kLeastStep_s;
  } else {
    shorter_ = new_step_s < kShorterSpacing * step_s_ ? shorter_ + 1 : 0;
    longer_ = new_step_s > kLossSpacing * step_s_ ? longer_ + 1 : 0;
    if (shorter_ < kShorterCount && longer_ < kLongerCount) return false;
  }
  shorter_ = longer_ = 0;
  step_s_ = new_step_s;
  steps_ = {};
  messages_until_choice_ = 0;
  return true;
}

bool Horizons::updateAge(double age_s) {
  if (!(age_s >= 0.0)) age_s = 0.0;
  if (least_age_s_ < 0.0) {
    least_age_s_ = age_s;
    age_95_s_ = age_s + 0.85 * std::max(step_s_, kLeastStep_s);
    messages_until_choice_ = 0;
    return true;
  }
  least_age_s_ = age_s < least_age_s_ ? age_s : least_age_s_ + 5e-4 * (age_s - least_age_s_);
  // Stochastic estimate of the 95 % quantile: up and down steps balance when one tick of twenty exceeds it.
  const double step = 0.02 * kLeastStep_s;
  age_95_s_ += age_s > age_95_s_ ? 0.95 * step : -0.05 * step;
  return false;
}

const Horizons::Steps* Horizons::choose() {
  if (least_age_s_ < 0.0 || step_s_ == 0.0) return nullptr;
  if (messages_until_choice_-- > 0) return nullptr;
  messages_until_choice_ = kChoiceInterval;
  const auto steps = [this](double age_s) { return static_cast<int>(std::min<double>(kMostSteps, age_s / step_s_)); };
  const int low = std::clamp(steps(least_age_s_ + 0.02 * step_s_), 1, kMostSteps - 1);
  const int high = std::clamp(steps(age_95_s_ + 0.98 * step_s_), low + 1, kMostSteps);
  const Steps wanted = {low, high, high - low >= 4 ? (low + high) / 2 : 0};
  if (wanted == steps_) return nullptr;
  steps_ = wanted;
  return &steps_;
}

}  // namespace fyd::teleop
