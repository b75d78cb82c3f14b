#include "core/signal/resonator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/portable_math.h"

namespace fyd::signal {
namespace {

double warped(double frequency_Hz, double sample_rate_Hz) {
  return math::tan(std::numbers::pi * std::clamp(frequency_Hz / sample_rate_Hz, 1e-5, 0.49));
}

}  // namespace

void Resonator::tune(double frequency_Hz, double quality, double sample_rate_Hz) {
  g_ = warped(frequency_Hz, sample_rate_Hz);
  k_ = 1.0 / std::max(quality, 0.1);
  normaliser_ = 1.0 / (1.0 + g_ * (g_ + k_));
}

double Resonator::step(double x) {
  constexpr double kTiny = 1e-30;
  const double band = (ic1_ + g_ * (x - ic2_)) * normaliser_;
  const double low = ic2_ + g_ * band;
  ic1_ = 2.0 * band - ic1_;
  ic2_ = 2.0 * low - ic2_;
  if (std::abs(ic1_) < kTiny) ic1_ = 0.0;
  if (std::abs(ic2_) < kTiny) ic2_ = 0.0;
  return k_ * band;
}

double Resonator::powerGain(double frequency_Hz, double sample_rate_Hz) const {
  const double w = warped(frequency_Hz, sample_rate_Hz) / g_;
  const double side = 1.0 - w * w;
  return k_ * k_ * w * w / (side * side + k_ * k_ * w * w);
}

}  // namespace fyd::signal
