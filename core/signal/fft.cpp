#include "core/signal/fft.h"

#include <algorithm>
#include <mutex>

#include <fftw3.h>

namespace fyd::signal {
namespace {

// The same bits on every processor: plans are not chosen by measurement, and no vector instructions, which FFTW selects
// by the processor it runs on.
constexpr unsigned kFlags = FFTW_ESTIMATE | FFTW_NO_SIMD;

// FFTW's planner is the one part of it that threads may not share.
std::mutex& plannerMutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

struct RealFft::Plans {
  explicit Plans(int n)
      : length(n),
        time(static_cast<double*>(fftw_malloc(sizeof(double) * static_cast<std::size_t>(n)))),
        bins(static_cast<std::complex<double>*>(
            fftw_malloc(sizeof(std::complex<double>) * static_cast<std::size_t>(n / 2 + 1)))) {
    const std::lock_guard lock(plannerMutex());
    auto* spectrum = reinterpret_cast<fftw_complex*>(bins);
    forward = fftw_plan_dft_r2c_1d(n, time, spectrum, kFlags | FFTW_PRESERVE_INPUT);
    backward = fftw_plan_dft_c2r_1d(n, spectrum, time, kFlags | FFTW_DESTROY_INPUT);
    std::fill_n(time, n, 0.0);
    std::fill_n(bins, n / 2 + 1, std::complex<double>());
  }
  ~Plans() {
    const std::lock_guard lock(plannerMutex());
    fftw_destroy_plan(forward);
    fftw_destroy_plan(backward);
    fftw_free(time);
    fftw_free(bins);
  }
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;

  int length;
  double* time;
  std::complex<double>* bins;
  fftw_plan forward = nullptr;
  fftw_plan backward = nullptr;
};

RealFft::RealFft(int length) : plans_(std::make_unique<Plans>(std::max(length, 1))) {}
RealFft::~RealFft() = default;
RealFft::RealFft(RealFft&&) noexcept = default;
RealFft& RealFft::operator=(RealFft&&) noexcept = default;

int RealFft::length() const { return plans_->length; }
std::span<double> RealFft::time() { return {plans_->time, static_cast<std::size_t>(plans_->length)}; }
std::span<std::complex<double>> RealFft::bins() {
  return {plans_->bins, static_cast<std::size_t>(plans_->length / 2 + 1)};
}

void RealFft::forward() { fftw_execute(plans_->forward); }

void RealFft::backward() {
  fftw_execute(plans_->backward);
  const double scale = 1.0 / plans_->length;
  for (double& x : time()) x *= scale;
}

}  // namespace fyd::signal
