#include "core/texture/contact_detector.h"

#include <algorithm>
#include <cmath>

namespace fyd::texture {
namespace {

constexpr double kFast_s = 0.004;
constexpr double kSlow_s = 0.025;
constexpr double kFloor_s = 1.0;
constexpr double kLearn_s = 0.1;
constexpr double kKnock_s = 0.025;  // the touch's own vibration
constexpr double kPause_s = 0.01;
constexpr double kSteady = 0.25;
constexpr double kTinyPower = 1e-24;  // g²

}  // namespace

ContactDetector::ContactDetector(const ContactParameters& parameters, double sample_rate_Hz)
    : parameters_(parameters), sample_rate_Hz_(sample_rate_Hz) {
  const double corner_Hz = std::min(parameters.corner_Hz, 0.2 * sample_rate_Hz);
  filter_.setCoefficients(signal::highPass(corner_Hz, sample_rate_Hz));
}

void ContactDetector::reset() {
  filter_.reset();
  fast_ = slow_ = floor_ = 0.0;
  samples_ = since_touch_ = loud_ = pause_ = quiet_ = 0;
  touching_ = slipping_ = false;
}

double ContactDetector::threshold_g() const {
  return std::max(parameters_.threshold_ratio * std::sqrt(floor_), parameters_.minimum_g);
}

void ContactDetector::follow(double& mean, double power, double time_s) const {
  // Plain mean until `time_s` has passed, then exponential: the first samples count as much as later ones.
  const double share = std::max(1.0 / (time_s * sample_rate_Hz_), 1.0 / static_cast<double>(samples_));
  mean += std::min(share, 1.0) * (power - mean);
  if (mean < kTinyPower) mean = 0.0;
}

ContactEvent ContactDetector::step(const Vec3& acceleration_g) {
  constexpr double kLargest_g = 1e6;
  if (!acceleration_g.finite() || acceleration_g.norm() > kLargest_g) return ContactEvent::none;
  if (samples_ == 0) filter_.settleAt(acceleration_g);
  ++samples_;
  const Vec3 h = filter_.step(acceleration_g);
  const double power = h.x * h.x + h.y * h.y + h.z * h.z;
  follow(fast_, power, kFast_s);
  follow(slow_, power, kSlow_s);

  const double threshold = threshold_g();
  if (!after(samples_, kLearn_s)) {
    follow(floor_, power, kFloor_s);
    return ContactEvent::none;
  }
  const bool loud = fast_ > threshold * threshold;
  if (!touching_) {
    if (loud) return begin();
    follow(floor_, power, kFloor_s);
    return ContactEvent::none;
  }
  ++since_touch_;
  return during(loud, loud && fast_ > kSteady * slow_);
}

bool ContactDetector::after(std::int64_t samples, double time_s) const {
  return static_cast<double>(samples) >= time_s * sample_rate_Hz_;
}

ContactEvent ContactDetector::begin() {
  touching_ = true;
  slipping_ = false;
  since_touch_ = loud_ = pause_ = quiet_ = 0;
  return ContactEvent::touch;
}

ContactEvent ContactDetector::during(bool loud, bool sustained) {
  quiet_ = loud ? 0 : quiet_ + 1;
  if (after(quiet_, parameters_.release_ms * 1e-3)) {
    touching_ = slipping_ = false;
    return ContactEvent::release;
  }
  if (!after(since_touch_, kKnock_s)) return ContactEvent::none;
  pause_ = sustained ? 0 : pause_ + 1;
  if (after(pause_, kPause_s)) {
    loud_ = 0;
    slipping_ = false;
    return ContactEvent::none;
  }
  ++loud_;
  if (slipping_ || !after(loud_, parameters_.slip_ms * 1e-3)) return ContactEvent::none;
  slipping_ = true;
  return ContactEvent::slip;
}

}  // namespace fyd::texture
