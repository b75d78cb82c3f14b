#include "core/teleop/prediction/horizons.h"

#include <algorithm>
#include <cmath>

namespace fyd::teleop {
namespace {

constexpr double kSameStep = 0.05;  // spacings within this share of Δ are Δ
constexpr double kShorter = 0.7;
constexpr int kShorterInARow = 3, kLongerInARow = 12;
constexpr int kMostSteps = 96;
constexpr int kChoiceEvery = 16;  // messages

}  // namespace

bool Horizons::watchSpacing(double spacing_s) {
  double fitting_s = std::max(spacing_s, kLeastStep_s);
  if (step_s_ == 0.0) {
    if (std::abs(fitting_s - kLeastStep_s) < kSameStep * kLeastStep_s) fitting_s = kLeastStep_s;
  } else {
    shorter_ = fitting_s < kShorter * step_s_ ? shorter_ + 1 : 0;
    longer_ = fitting_s > kLonger * step_s_ ? longer_ + 1 : 0;
    if (shorter_ < kShorterInARow && longer_ < kLongerInARow) return false;
  }
  shorter_ = longer_ = 0;
  step_s_ = fitting_s;
  steps_ = {};
  until_choice_ = 0;
  return true;
}

bool Horizons::watchAge(double age_s) {
  if (!(age_s >= 0.0)) age_s = 0.0;
  if (least_age_s_ < 0.0) {
    least_age_s_ = age_s;
    most_age_s_ = age_s + 0.85 * std::max(step_s_, kLeastStep_s);
    until_choice_ = 0;
    return true;
  }
  least_age_s_ = age_s < least_age_s_ ? age_s : least_age_s_ + 5e-4 * (age_s - least_age_s_);
  // Towards the age that one tick of twenty exceeds.
  const double step = 0.02 * kLeastStep_s;
  most_age_s_ += age_s > most_age_s_ ? 0.95 * step : -0.05 * step;
  return false;
}

const Horizons::Steps* Horizons::choose() {
  if (least_age_s_ < 0.0 || step_s_ == 0.0) return nullptr;
  if (until_choice_-- > 0) return nullptr;
  until_choice_ = kChoiceEvery;
  const auto steps = [this](double age_s) { return static_cast<int>(std::min<double>(kMostSteps, age_s / step_s_)); };
  const int low = std::clamp(steps(least_age_s_ + 0.02 * step_s_), 1, kMostSteps - 1);
  const int high = std::clamp(steps(most_age_s_ + 0.98 * step_s_), low + 1, kMostSteps);
  const Steps wanted = {low, high, high - low >= 4 ? (low + high) / 2 : 0};
  if (wanted == steps_) return nullptr;
  steps_ = wanted;
  return &steps_;
}

}  // namespace fyd::teleop
