#include "core/sensing/indentation_filter.h"

#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"

namespace fyd::sensing {
namespace {

constexpr double kHolds_s = 3.0;  // mean time for which a finger holds still …
constexpr double kMoves_s = 0.2;  // … and moves
constexpr double kLongestFilterStep_s = 1.0;
constexpr double kLargest_mm = 200.0;  // beyond any cloth: keeps the arithmetic finite
constexpr double kOutlier = 5.0;       // standard deviations from what a moving finger allows
constexpr int kPersistent = 4;         // after so many outliers in a row, readings are accepted
constexpr double kDisagreementShare = 0.05;

}  // namespace

void IndentationFilter::configure(double holding_mm_per_sqrt_s, double moving_mm_per_sqrt_s, double start_mm,
                                  double start_sigma_mm, double start_holding) {
  prior_holding_ = start_holding;
  prior_ = {.mean = start_mm, .variance = start_sigma_mm * start_sigma_mm};
  process_noise_ = {holding_mm_per_sqrt_s * holding_mm_per_sqrt_s, moving_mm_per_sqrt_s * moving_mm_per_sqrt_s};
}

void IndentationFilter::restart() {
  modes_ = {prior_, prior_};
  probability_ = {prior_holding_, 1.0 - prior_holding_};
  disagreement_ = 1.0;
  left_out_in_a_row_ = 0;
  combine();
}

double IndentationFilter::sigma_mm() const { return std::sqrt(variance_); }

void IndentationFilter::update(double dt_s, std::span<Measurement> measurements) {
  mix(std::isfinite(dt_s) ? std::clamp(dt_s, 0.0, kLongestFilterStep_s) : 0.0);

  // Outliers are judged against the moving filter's estimate, which is the wider one, before any reading is used.
  const Gaussian& wide = modes_[1];
  bool any_left_out = false;
  for (Measurement& m : measurements) {
    m.used = std::isfinite(m.z_mm) && std::isfinite(m.h) && std::isfinite(m.sigma_mm) && m.sigma_mm > 0.0;
    if (!m.used) continue;
    const double innovation = m.z_mm - m.h * wide.mean;
    const double variance = m.h * m.h * wide.variance + m.sigma_mm * m.sigma_mm;
    if (innovation * innovation > kOutlier * kOutlier * variance && left_out_in_a_row_ < kPersistent) {
      m.used = false;
      any_left_out = true;
    }
  }
  left_out_in_a_row_ = any_left_out ? left_out_in_a_row_ + 1 : 0;

  std::array<double, 2> log_likelihood{};
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    Gaussian& b = modes_[i];
    for (const Measurement& m : measurements) {
      if (!m.used) continue;
      const double innovation = m.z_mm - m.h * b.mean;
      const double variance = m.h * m.h * b.variance + m.sigma_mm * m.sigma_mm;
      const double gain = b.variance * m.h / variance;
      b.mean = std::clamp(b.mean + gain * innovation, -kLargest_mm, kLargest_mm);
      b.variance = std::max(b.variance * (1.0 - gain * m.h), 1e-9);
      log_likelihood[i] -= 0.5 * (innovation * innovation / variance + math::log(variance));
    }
  }
  const double top = std::max(log_likelihood[0], log_likelihood[1]);
  const double holding = probability_[0] * math::exp(log_likelihood[0] - top);
  const double moving = probability_[1] * math::exp(log_likelihood[1] - top);
  if (holding + moving > 0.0) {
    probability_[0] = std::clamp(holding / (holding + moving), 1e-3, 1.0 - 1e-3);
    probability_[1] = 1.0 - probability_[0];
  }
  combine();

  double squares = 0.0;
  int used = 0;
  for (const Measurement& m : measurements) {
    if (!std::isfinite(m.z_mm) || !std::isfinite(m.h) || !(m.sigma_mm > 0.0)) continue;
    const double residual = (m.z_mm - m.h * value_) / m.sigma_mm;
    squares += std::min(residual * residual, 1e6);
    ++used;
  }
  if (used >= 2) disagreement_ += kDisagreementShare * (squares / (used - 1) - disagreement_);
}

void IndentationFilter::mix(double dt_s) {
  const std::array<double, 2> leaves = {1.0 - math::exp(-dt_s / kHolds_s), 1.0 - math::exp(-dt_s / kMoves_s)};
  const std::array<Gaussian, 2> before = modes_;
  const std::array<double, 2> prior = probability_;
  for (std::size_t to = 0; to < 2; ++to) {
    const std::size_t other = 1 - to;
    const double stays = (1.0 - leaves[to]) * prior[to];
    const double comes = leaves[other] * prior[other];
    const double sum = stays + comes;
    const double mean = (stays * before[to].mean + comes * before[other].mean) / sum;
    const double spread_own = before[to].mean - mean;
    const double spread_other = before[other].mean - mean;
    modes_[to].mean = mean;
    modes_[to].variance = (stays * (before[to].variance + spread_own * spread_own) +
                           comes * (before[other].variance + spread_other * spread_other)) /
                              sum +
                          process_noise_[to] * dt_s;
    modes_[to].variance = std::min(modes_[to].variance, kLargest_mm * kLargest_mm);
    probability_[to] = sum;
  }
}

void IndentationFilter::combine() {
  value_ = probability_[0] * modes_[0].mean + probability_[1] * modes_[1].mean;
  variance_ = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const double spread = modes_[i].mean - value_;
    variance_ += probability_[i] * (modes_[i].variance + spread * spread);
  }
}

double ThesisSmoother::update(double value_mm) {
  constexpr int kEnough = 5;
  if (!std::isfinite(value_mm)) return value_;
  if (!started_) {
    started_ = true;
    value_ = value_mm;
    return value_;
  }
  if (std::abs(value_mm - value_) < kGate_mm) {
    refusals_ = 0;
    value_ = kOldShare * value_ + (1.0 - kOldShare) * value_mm;
    return value_;
  }
  refusals_ = refusals_ > 0 && std::abs(value_mm - refused_) < kGate_mm ? refusals_ + 1 : 1;
  refused_ = value_mm;
  if (refusals_ >= kEnough) {
    refusals_ = 0;
    value_ = value_mm;
  }
  return value_;
}

}  // namespace fyd::sensing
