#include "core/texture/felt/inverse_cloth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Core>

#include "core/base/portable_math.h"
#include "core/signal/minimum_phase.h"

namespace fyd::texture {
namespace {

// More would match the spectrum better and be felt less, because the motors' duty is limited.
const double kLargestLogGain = 14.0 / 20.0 * std::numbers::ln10;

using Taps = Eigen::Map<Eigen::ArrayXd>;

}  // namespace

InverseCloth::InverseCloth(double sample_rate_Hz) : rate_Hz_(sample_rate_Hz), fft_(kFrame) {
  taps_[0] = goal_[0] = 1.0;
}

void InverseCloth::reset() {
  taps_ = goal_;
  gliding_ = 0;
  recent_.fill(0.0);
  newest_ = 0;
}

void InverseCloth::tune(double resonance_Hz, double damping) {
  const auto bins = fft_.bins();
  for (std::size_t k = 0; k < bins.size(); ++k) {
    const double f = static_cast<double>(k) / kFrame;  // of the rate
    const double r = f * rate_Hz_ / resonance_Hz;
    const double across = math::square(2.0 * damping * r);
    const double log_cloth = 0.5 * math::log((1.0 + across) / (math::square(1.0 - r * r) + across));
    const double held = k == 0 ? 1.0 : math::sin(std::numbers::pi * f) / (std::numbers::pi * f);
    bins[k] = std::min(-log_cloth - math::log(held), kLargestLogGain);
  }
  signal::minimumPhase(fft_);
  std::copy_n(fft_.time().begin(), kTaps, goal_.begin());
  gliding_ = kGlide;
}

double InverseCloth::step(double wanted) {
  newest_ = newest_ == 0 ? kTaps - 1 : newest_ - 1;
  recent_[static_cast<std::size_t>(newest_)] = wanted;
  recent_[static_cast<std::size_t>(newest_ + kTaps)] = wanted;
  Taps taps(taps_.data(), kTaps);
  if (gliding_ > 0) {
    taps += (Taps(goal_.data(), kTaps) - taps) / gliding_;
    --gliding_;
  }
  return (taps * Taps(recent_.data() + newest_, kTaps)).sum();
}

}  // namespace fyd::texture
