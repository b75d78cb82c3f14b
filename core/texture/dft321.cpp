#include "core/texture/dft321.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/portable_math.h"
#include "core/texture/phase_rule.h"

namespace fyd::texture {

Dft321Frame::Dft321Frame(int length) : fft_(length) {
  for (auto& spectrum : spectra_) spectrum.resize(fft_.bins().size());
}

std::span<const std::complex<double>> Dft321Frame::spectrumOf(std::span<const double> axis, std::size_t index) {
  std::copy(axis.begin(), axis.end(), fft_.time().begin());
  fft_.forward();
  std::copy(fft_.bins().begin(), fft_.bins().end(), spectra_[index].begin());
  return spectra_[index];
}

std::span<const double> Dft321Frame::transform(std::span<const double> x, std::span<const double> y,
                                               std::span<const double> z) {
  const auto a = spectrumOf(x, 0);
  const auto b = spectrumOf(y, 1);
  const auto c = spectrumOf(z, 2);
  const auto bins = fft_.bins();
  for (std::size_t k = 0; k < bins.size(); ++k) bins[k] = combineAxes(a[k], b[k], c[k]);
  fft_.backward();
  return fft_.time();
}

Dft321::Dft321(int frame, int hop, double sample_rate_Hz) : frame_(frame), hop_(hop), transform_(frame) {
  const auto n = static_cast<std::size_t>(frame);
  for (auto& axis : history_) axis.resize(n);
  output_.resize(n);
  if (hop_ < frame_) {
    equaliser_.emplace(sample_rate_Hz);
    delayed_.resize(n);
    for (auto& axis : windowed_) axis.resize(n);
    window_.resize(n);
    const double scale = std::sqrt(2.0 * hop_ / frame_);  // Σ sin² over the overlapping frames is frame/(2·hop)
    for (std::size_t i = 0; i < n; ++i) {
      window_[i] = scale * math::sin(std::numbers::pi * static_cast<double>(i) / static_cast<double>(n));
    }
  }
  reset();
}

void Dft321::reset() {
  for (auto& axis : history_) std::fill(axis.begin(), axis.end(), 0.0);
  std::fill(output_.begin(), output_.end(), 0.0);
  std::fill(delayed_.begin(), delayed_.end(), Vec3{});
  if (equaliser_) equaliser_->reset();
  filled_ = oldest_ = 0;
}

double Dft321::step(const Vec3& filtered_g) {
  const int place = frame_ - hop_ + filled_;
  const auto at = static_cast<std::size_t>(place);
  history_[0][at] = filtered_g.x;
  history_[1][at] = filtered_g.y;
  history_[2][at] = filtered_g.z;
  if (++filled_ == hop_) {
    process();
    filled_ = 0;
  }
  const double mixed = output_[static_cast<std::size_t>(filled_)];
  if (!equaliser_) return mixed;
  delayed_[static_cast<std::size_t>(oldest_)] = filtered_g;
  oldest_ = oldest_ + 1 == frame_ ? 0 : oldest_ + 1;
  return equaliser_->step(mixed, delayed_[static_cast<std::size_t>(oldest_)]);
}

void Dft321::process() {
  if (!equaliser_) {
    const auto result = transform_.transform(history_[0], history_[1], history_[2]);
    std::copy(result.begin(), result.end(), output_.begin());
    return;
  }
  const auto n = static_cast<std::size_t>(frame_);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < n; ++i) windowed_[axis][i] = window_[i] * history_[axis][i];
    std::copy(history_[axis].begin() + hop_, history_[axis].end(), history_[axis].begin());
  }
  const auto result = transform_.transform(windowed_[0], windowed_[1], windowed_[2]);
  std::copy(output_.begin() + hop_, output_.end(), output_.begin());
  std::fill(output_.end() - hop_, output_.end(), 0.0);
  for (std::size_t i = 0; i < n; ++i) output_[i] += window_[i] * result[i];
}

ThesisDft321::ThesisDft321(int frame) : frame_(frame), fft_(frame) {
  const auto n = static_cast<std::size_t>(frame);
  for (auto& axis : stored_) axis.resize(n + 1);
  playing_.resize(n + 1);
  energy_.resize(fft_.bins().size());
  sum_.resize(fft_.bins().size());
  reset();
}

void ThesisDft321::reset() {
  for (auto& axis : stored_) std::fill(axis.begin(), axis.end(), 0.0);
  std::fill(playing_.begin(), playing_.end(), 0.0);
  index_ = 0;
}

double ThesisDft321::step(const Vec3& filtered_g) {
  const auto at = static_cast<std::size_t>(index_);
  const double out = playing_[at];
  stored_[0][at] = filtered_g.x;
  stored_[1][at] = filtered_g.y;
  stored_[2][at] = filtered_g.z;
  if (++index_ <= frame_) return out;

  index_ = 0;
  std::fill(energy_.begin(), energy_.end(), 0.0);
  std::fill(sum_.begin(), sum_.end(), 0.0);
  for (const auto& axis : stored_) {
    std::copy(axis.begin(), axis.end() - 1, fft_.time().begin());
    fft_.forward();
    for (std::size_t k = 0; k < sum_.size(); ++k) {
      sum_[k] += fft_.bins()[k];
      energy_[k] += std::norm(fft_.bins()[k]);
    }
  }
  for (std::size_t k = 0; k < sum_.size(); ++k) fft_.bins()[k] = math::polar(std::sqrt(energy_[k]), math::arg(sum_[k]));
  fft_.backward();
  std::copy(fft_.time().begin(), fft_.time().end(), playing_.begin());
  playing_.back() = 0.0;
  return out;
}

}  // namespace fyd::texture
