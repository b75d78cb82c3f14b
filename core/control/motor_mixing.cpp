#include "core/control/motor_mixing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fyd::control {
namespace {

/// Signed angle from the zero on the circle, −180…180°.
double angleOf(int counts, int zero_counts, bool inverted) {
  int turned = (counts - zero_counts) % kEncoderCountsPerTurn;
  if (turned < -kEncoderCountsPerTurn / 2) turned += kEncoderCountsPerTurn;
  if (turned >= kEncoderCountsPerTurn / 2) turned -= kEncoderCountsPerTurn;
  return (inverted ? -turned : turned) / kEncoderCountsPerDegree;
}

}  // namespace

RollerAngles rollerAngles(const MotorFeedback& feedback, const ControlParameters& p) {
  const auto [first_counts, second_counts] = feedback.encoder_counts;
  if (first_counts >= kEncoderCountsPerTurn || second_counts >= kEncoderCountsPerTurn) return {};
  const double first = angleOf(first_counts, p.encoder_zero_first_counts, p.encoder_first_inverted);
  const double second = angleOf(second_counts, p.encoder_zero_second_counts, p.encoder_second_inverted);
  return {0.5 * (first - second), 0.5 * (first + second), true};
}

std::int16_t ticksFromDegrees(double angle_deg) {
  if (std::isnan(angle_deg)) return 0;
  using Limits = std::numeric_limits<std::int16_t>;
  const double ticks = std::round(angle_deg * kTicksPerDegree);
  return static_cast<std::int16_t>(
      std::clamp(ticks, static_cast<double>(Limits::min()), static_cast<double>(Limits::max())));
}

MotorMixing::MotorMixing(const ControlParameters& parameters) { configure(parameters); }

void MotorMixing::configure(const ControlParameters& parameters) { motor_limit_deg_ = parameters.motor_limit_deg; }

void MotorMixing::mix(double stretch_deg, double translation_deg, MotorCommand& command) {
  if (std::isfinite(stretch_deg)) stretch_deg_ = std::clamp(stretch_deg, -motor_limit_deg_, motor_limit_deg_);
  if (std::isfinite(translation_deg)) translation_deg_ = translation_deg;
  const double room_deg = std::max(0.0, motor_limit_deg_ - std::abs(stretch_deg_));
  const double translation = std::clamp(translation_deg_, -room_deg, room_deg);
  command.reference_ticks = {ticksFromDegrees(stretch_deg_ + translation),
                             ticksFromDegrees(translation - stretch_deg_)};
}

}  // namespace fyd::control
