#include "core/texture/finger_speed.h"

#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"

namespace fyd::texture {
namespace {

constexpr double kHeldFor_s = 0.1;
constexpr double kGoneAfter_s = 0.2;

}  // namespace

void FingerSpeed::observe(double x_mm, double y_mm, Instant taken) {
  if (!std::isfinite(x_mm) || !std::isfinite(y_mm)) return;
  if (seen_ && taken <= taken_) return;
  const double elapsed_s = seen_ ? toSeconds(taken - taken_) : 0.0;
  if (seen_ && elapsed_s <= kGoneAfter_s) {
    const double raw = math::hypot(x_mm - x_mm_, y_mm - y_mm_) / elapsed_s;
    speed_mm_s_ = 0.5 * speed_mm_s_ + 0.5 * std::min(raw, kFastest_mm_s);
  } else {
    speed_mm_s_ = 0.0;  // a new touch, or one too long ago to tell how the finger came here
  }
  seen_ = true;
  x_mm_ = x_mm;
  y_mm_ = y_mm;
  taken_ = taken;
}

void FingerSpeed::lift() {
  seen_ = false;
  speed_mm_s_ = 0.0;
}

double FingerSpeed::at(Instant now) const {
  if (!seen_) return 0.0;
  const double age_s = toSeconds(now - taken_);
  const double left = (kGoneAfter_s - age_s) / (kGoneAfter_s - kHeldFor_s);
  return speed_mm_s_ * std::clamp(left, 0.0, 1.0);
}

}  // namespace fyd::texture
