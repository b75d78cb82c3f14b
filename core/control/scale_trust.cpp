#include "core/control/scale_trust.h"

#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"

namespace fyd::control {
namespace {

constexpr double kDistrust_s = 1.0;     // of disagreement, until the law alone is used
constexpr double kAgreeAgain = 0.8;     // of the limit: hysteresis against noise at the limit
constexpr double kTrustAgain_s = 0.25;  // of agreement, until the measurement counts fully again

double logOf(double relative) { return std::isfinite(relative) && relative > 0 ? math::log(1.0 + relative) : 0.0; }

}  // namespace

void ScaleTrust::configure(double bias, double limit, CorrectionRule rule) {
  rule_ = rule;
  bias_log_ = logOf(bias);
  limit_log_ = logOf(limit);
}

void ScaleTrust::reset() {
  corrected_ = 0.0;
  trust_ = 1.0;
  contradicted_ = false;
}

void ScaleTrust::step(double log_scale, double dt_s) {
  if (!std::isfinite(log_scale)) log_scale = 0.0;
  const double size = std::abs(log_scale);
  const double excess = std::max(0.0, size - bias_log_);
  const double corrected = rule_ == CorrectionRule::excess ? excess : std::min(size, 2.0 * excess);
  corrected_ = std::copysign(std::min(corrected, limit_log_), log_scale);
  const bool disagree = excess > limit_log_ * (contradicted_ ? kAgreeAgain : 1.0);
  trust_ = std::clamp(trust_ + (disagree ? -dt_s / kDistrust_s : dt_s / kTrustAgain_s), 0.0, 1.0);
  contradicted_ = trust_ <= 0.0 || (contradicted_ && disagree);
}

}  // namespace fyd::control
