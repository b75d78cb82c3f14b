// Touch and slip onset from acceleration alone (the idea is the thesis' chapter 8, the method is this project's).
//
//   h      = second-order high-pass of each axis (corner_Hz)
//   fast²  = mean of |h|² over 4 ms,   slow² = mean of |h|² over 25 ms   (both exponential)
//   floor² = mean of |h|² over 1 s, taken only while nothing is touched and fast is below the threshold
//   threshold = max(threshold_ratio · floor, minimum_g)
//
// Touch: fast rises above the threshold out of quiet.
// Slip onset: after a touch, its first 25 ms (the impact itself) not counted, fast stays above the threshold for
// `slip_ms` with no pause of 10 ms. The decay of an impact does not count: while it decays, fast² < slow²/4.
// Acceleration does not tell a still contact from none: `release_ms` of quiet ends it.
#pragma once

#include <cstdint>

#include "core/base/vec3.h"
#include "core/signal/high_pass.h"

namespace fyd::texture {

struct ContactParameters {
  double corner_Hz = 20.0;       ///< below Nyquist; lowered to 0.2 of the rate when it is not
  double threshold_ratio = 6.0;  ///< multiples of the noise floor's RMS
  double minimum_g = 0.01;       ///< threshold in perfect silence
  double slip_ms = 40.0;
  double release_ms = 150.0;
};

enum class ContactEvent : std::uint8_t { none, touch, slip, release };

class ContactDetector {
 public:
  ContactDetector(const ContactParameters& parameters, double sample_rate_Hz);

  /// One sample, in g. A sample that is not finite is skipped. For the first 100 ms the floor is learnt and nothing is
  /// reported.
  [[nodiscard]] ContactEvent step(const Vec3& acceleration_g);
  void reset();

  [[nodiscard]] bool touching() const { return touching_; }
  [[nodiscard]] double threshold_g() const;

 private:
  void follow(double& mean, double power, double time_s) const;
  [[nodiscard]] bool after(std::int64_t samples, double time_s) const;
  ContactEvent begin();
  ContactEvent during(bool loud, bool sustained);

  ContactParameters parameters_;
  double sample_rate_Hz_;
  signal::HighPass3 filter_;
  double fast_ = 0.0;
  double slow_ = 0.0;
  double floor_ = 0.0;
  std::int64_t samples_ = 0;
  std::int64_t since_touch_ = 0;
  std::int64_t loud_ = 0;
  std::int64_t pause_ = 0;
  std::int64_t quiet_ = 0;
  bool touching_ = false;
  bool slipping_ = false;
};

}  // namespace fyd::texture
