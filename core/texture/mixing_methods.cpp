#include "core/texture/mixing_methods.h"

#include <algorithm>
#include <cmath>

namespace fyd::texture {
namespace {

constexpr double kMagnitudeMean_s = 0.1;
constexpr double kCovarianceTime_s = 0.25;
constexpr double kTiny = 1e-30;
constexpr double kStuck = 1e-9, kNudge = 1e-3;  // of the largest power along a sensor's axis
// No symmetric pattern is orthogonal to this, so that the first power iteration never starts from nothing.
constexpr Vec3 kFirstAxis = {0.80, 0.48, 0.36};

double share(double time_s, double sample_rate_Hz) { return std::min(1.0, 1.0 / (time_s * sample_rate_Hz)); }
double flushed(double v) { return std::abs(v) < kTiny ? 0.0 : v; }

}  // namespace

Magnitude::Magnitude(double sample_rate_Hz) : share_(share(kMagnitudeMean_s, sample_rate_Hz)) {}

double Magnitude::step(const Vec3& filtered_g) {
  const double magnitude = filtered_g.norm();
  mean_ = flushed(mean_ + share_ * (magnitude - mean_));
  return magnitude - mean_;
}

PrincipalAxis::PrincipalAxis(double sample_rate_Hz)
    : share_(share(kCovarianceTime_s, sample_rate_Hz)), axis_(kFirstAxis) {}

void PrincipalAxis::reset() {
  covariance_.fill(0.0);
  axis_ = kFirstAxis;
}

double PrincipalAxis::step(const Vec3& a) {
  const std::array<double, 6> products = {a.x * a.x, a.y * a.y, a.z * a.z, a.x * a.y, a.x * a.z, a.y * a.z};
  for (std::size_t i = 0; i < products.size(); ++i) {
    covariance_[i] = flushed(covariance_[i] + share_ * (products[i] - covariance_[i]));
  }
  const auto& c = covariance_;
  Vec3 next = {c[0] * axis_.x + c[3] * axis_.y + c[4] * axis_.z, c[3] * axis_.x + c[1] * axis_.y + c[5] * axis_.z,
               c[4] * axis_.x + c[5] * axis_.y + c[2] * axis_.z};
  // On a direction that the covariance does not turn, though another has more power (x went silent, y began), power
  // iteration stays for ever: a little of the first axis lets it find the other.
  const double along = next.x * axis_.x + next.y * axis_.y + next.z * axis_.z;
  const double most = std::max({c[0], c[1], c[2]});
  const Vec3 turned = next - along * axis_;
  if (along < (1.0 - kStuck) * most &&
      turned.x * turned.x + turned.y * turned.y + turned.z * turned.z <= kStuck * most * kStuck * most)
    next = next + kNudge * most * kFirstAxis;
  const double length = std::sqrt(next.x * next.x + next.y * next.y + next.z * next.z);
  if (length > kTiny) axis_ = (1.0 / length) * next;
  return axis_.x * a.x + axis_.y * a.y + axis_.z * a.z;
}

double Recolour::step(const Vec3& a) { return equaliser_.step(a.x + 0.6 * a.y + 0.36 * a.z, a); }

}  // namespace fyd::texture
