#include "core/texture/felt/inverse_cloth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Core>

#include "core/base/portable_math.h"
#include "core/signal/minimum_phase.h"

namespace fyd::texture {
namespace {

// A larger gain would match the spectrum better, but use up the limited duty at frequencies where it moves the finger
// least.
const double kLargestLogGain = 14.0 / 20.0 * std::numbers::ln10;

using MappedTaps = Eigen::Map<Eigen::ArrayXd>;

}  // namespace

InverseCloth::InverseCloth(double sample_rate_Hz) : rate_Hz_(sample_rate_Hz), fft_(kFrame) {
  taps_[0] = target_taps_[0] = 1.0;
}

void InverseCloth::reset() {
  taps_ = target_taps_;
  transition_left_ = 0;
  delay_line_.fill(0.0);
  newest_ = 0;
}

void InverseCloth::tune(double resonance_Hz, double damping) {
  const auto bins = fft_.bins();
  for (std::size_t k = 0; k < bins.size(); ++k) {
    const double f = static_cast<double>(k) / kFrame;  // relative to the sampling rate
    const double r = f * rate_Hz_ / resonance_Hz;
    const double damping_term = math::square(2.0 * damping * r);
    const double log_magnitude = 0.5 * math::log((1.0 + damping_term) / (math::square(1.0 - r * r) + damping_term));
    const double hold_gain = k == 0 ? 1.0 : math::sin(std::numbers::pi * f) / (std::numbers::pi * f);
    bins[k] = std::min(-log_magnitude - math::log(hold_gain), kLargestLogGain);
  }
  signal::minimumPhase(fft_);
  std::copy_n(fft_.time().begin(), kTaps, target_taps_.begin());
  transition_left_ = kTransitionSamples;
}

double InverseCloth::step(double wanted) {
  newest_ = newest_ == 0 ? kTaps - 1 : newest_ - 1;
  delay_line_[static_cast<std::size_t>(newest_)] = wanted;
  delay_line_[static_cast<std::size_t>(newest_) + kTaps] = wanted;
  MappedTaps taps(taps_.data(), kTaps);
  if (transition_left_ > 0) {
    taps += (MappedTaps(target_taps_.data(), kTaps) - taps) / transition_left_;
    --transition_left_;
  }
  return (taps * MappedTaps(delay_line_.data() + newest_, kTaps)).sum();
}

}  // namespace fyd::texture
