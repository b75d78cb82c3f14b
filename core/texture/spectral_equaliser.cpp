#include "core/texture/spectral_equaliser.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <Eigen/Core>

#include "core/base/portable_math.h"
#include "core/signal/minimum_phase.h"

namespace fyd::texture {
namespace {

constexpr double kSpectrumTime_s = 0.3;
constexpr double kTrimTime_s = 0.5;
constexpr double kFewestSpectrum = 300.0;  // samples that the spectra average over at least, for low rates
constexpr double kFewestTrim = 500.0;
constexpr double kBoostFloor = 1e-4;  // of the strongest bin: nothing weaker is boosted
const double kLargestLogBoost = 18.0 / 20.0 * std::numbers::ln10;
constexpr double kLargestTrim = 1.4142135623730951;  // 3 dB
constexpr double kSilence = 1e-30;                   // g²: below, smoothed powers become exactly zero
// Frame power of about 1e-6 g RMS, far below any sensor's noise: spectra fainter than this are not learned from.
constexpr double kFaint = 1e-10;

using Taps = Eigen::Map<Eigen::ArrayXd>;

double flushedPower(double power) { return power < kSilence ? 0.0 : power; }

}  // namespace

SpectralEqualiser::SpectralEqualiser(double sample_rate_Hz)
    : fft_(kFrame),
      frame_share_(std::min(1.0, kHop / std::max(kSpectrumTime_s * sample_rate_Hz, kFewestSpectrum))),
      trim_share_(std::min(1.0, 1.0 / std::max(kTrimTime_s * sample_rate_Hz, kFewestTrim))) {
  for (std::size_t i = 0; i < kFrame; ++i) {
    window_[i] = 0.5 - 0.5 * math::cos(2.0 * std::numbers::pi * static_cast<double>(i) / kFrame);
  }
  reset();
}

void SpectralEqualiser::reset() {
  for (auto& axis : history_) axis.fill(0.0);
  reference_.fill(0.0);
  power_.fill(0.0);
  taps_.fill(0.0);
  taps_[0] = 1.0;
  next_taps_ = taps_;
  tap_steps_.fill(0.0);
  recent_.fill(0.0);
  newest_ = 0;
  filled_ = 0;
  frames_ = 0;
  energy_in_ = energy_out_ = frame_energy_ = 0.0;
}

double SpectralEqualiser::step(double signal, const Vec3& axes) {
  const auto at = kFrame - kHop + static_cast<std::size_t>(filled_);
  history_[0][at] = axes.x;
  history_[1][at] = axes.y;
  history_[2][at] = axes.z;
  history_[3][at] = signal;
  ++filled_;
  if (filled_ == kHop / 2 && frames_ > 0) design();
  if (filled_ == kHop) {
    measure();
    for (auto& axis : history_) std::copy(axis.begin() + kHop, axis.end(), axis.begin());
    filled_ = 0;
  }
  return trimmed(filtered(signal), axes);
}

void SpectralEqualiser::measure() {
  std::array<double, kBins> reference{};
  std::array<double, kBins> power{};
  for (std::size_t axis = 0; axis < history_.size(); ++axis) {
    for (std::size_t i = 0; i < kFrame; ++i) fft_.time()[i] = window_[i] * history_[axis][i];
    fft_.forward();
    auto& sum = axis < 3 ? reference : power;
    for (std::size_t k = 0; k < kBins; ++k) sum[k] += std::norm(fft_.bins()[k]);
  }
  double energy = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double v : history_[axis]) energy += v * v;
  }
  // The first frames are averaged plainly, so that a new signal is not compared with the silence before it.
  ++frames_;
  const double share = std::max(frame_share_, 1.0 / frames_);
  if (frames_ > 1000) frames_ = 1000;
  frame_energy_ = flushedPower(frame_energy_ + share * (energy - frame_energy_));
  for (std::size_t k = 0; k < kBins; ++k) {
    reference_[k] = flushedPower(reference_[k] + share * (reference[k] - reference_[k]));
    power_[k] = flushedPower(power_[k] + share * (power[k] - power_[k]));
  }
}

void SpectralEqualiser::design() {
  // With the frame's energy before the window: an onset at the window's edge is loud, though its spectrum is faint.
  const double strongest = std::max(*std::max_element(reference_.begin(), reference_.end()), frame_energy_);
  taps_ = next_taps_;
  tap_steps_.fill(0.0);
  if (strongest <= kFaint) return;  // nothing to learn from: keep the last filter

  const auto bins = fft_.bins();
  const double floor = kBoostFloor * strongest;
  for (std::size_t k = 0; k < kBins; ++k) {
    const double log_gain = 0.5 * math::log((reference_[k] + floor) / (power_[k] + floor));
    bins[k] = std::clamp(log_gain, -kLargestLogBoost, kLargestLogBoost);
  }
  signal::minimumPhase(fft_);
  const auto response = fft_.time();
  for (std::size_t i = 0; i < kTaps; ++i) {
    next_taps_[i] = response[i];
    tap_steps_[i] = (next_taps_[i] - taps_[i]) / kHop;
  }
}

double SpectralEqualiser::filtered(double signal) {
  // The signal is stored twice, kTaps apart, so that the newest kTaps samples always stand in one row.
  newest_ = newest_ == 0 ? kTaps - 1 : newest_ - 1;
  recent_[static_cast<std::size_t>(newest_)] = signal;
  recent_[static_cast<std::size_t>(newest_) + kTaps] = signal;
  Taps taps(taps_.data(), kTaps);
  taps += Taps(tap_steps_.data(), kTaps);
  return (taps * Taps(recent_.data() + newest_, kTaps)).sum();
}

double SpectralEqualiser::trimmed(double equalised, const Vec3& axes) {
  const double in = axes.x * axes.x + axes.y * axes.y + axes.z * axes.z;
  energy_in_ = flushedPower(energy_in_ + trim_share_ * (in - energy_in_));
  energy_out_ = flushedPower(energy_out_ + trim_share_ * (equalised * equalised - energy_out_));
  if (energy_in_ <= 0.0 || energy_out_ <= 0.0) return equalised;
  return equalised * std::clamp(std::sqrt(energy_in_ / energy_out_), 1.0 / kLargestTrim, kLargestTrim);
}

}  // namespace fyd::texture
