#include "core/texture/pwm.h"

#include <algorithm>
#include <cmath>

namespace fyd::texture {
namespace {

Duty limited(double percent, double low, double high) {
  const double inside = std::clamp(percent, low, high);
  return {.percent = inside, .clipped = inside != percent};
}

Duty withDeadZone(Duty duty, double dead_zone_percent) {
  if (std::abs(duty.percent) < dead_zone_percent) duty.percent = 0.0;
  return duty;
}

}  // namespace

Duty symmetricDuty(double signal_g, const PwmSettings& s) {
  const double wanted = std::round(s.k_vib * (signal_g / s.full_scale_g) * s.maximum_percent);
  if (std::isnan(wanted) || !std::isfinite(signal_g)) return {};
  return withDeadZone(limited(wanted, -s.maximum_percent, s.maximum_percent), s.dead_zone_percent);
}

Duty thesisDuty(double signal_g, const PwmSettings& s) {
  const double wanted = std::floor(signal_g / s.full_scale_g * s.maximum_percent);
  if (std::isnan(wanted) || !std::isfinite(signal_g)) return {};
  Duty duty = withDeadZone(limited(wanted, -s.maximum_percent, s.maximum_percent), s.dead_zone_percent);
  duty.percent *= s.k_vib;
  return duty;
}

Duty limitDuty(const Duty& wanted, double maximum_percent, double position_share_percent) {
  if (!std::isfinite(wanted.percent)) return {};
  const double share = std::isfinite(position_share_percent) ? std::clamp(position_share_percent, -100.0, 100.0) : 0.0;
  const double most = std::clamp(maximum_percent, 0.0, 100.0);
  Duty duty = limited(wanted.percent, std::max(-most, -100.0 - share), std::min(most, 100.0 - share));
  duty.clipped = duty.clipped || wanted.clipped;
  return duty;
}

}  // namespace fyd::texture
