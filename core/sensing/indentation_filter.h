// Filters behind the indentation estimate: two interacting Kalman filters, and the thesis' gate and smoothing.
// Stability: may change
#pragma once

#include <array>
#include <span>

#include "core/base/api.h"
#include "core/base/state.h"

namespace fyd::sensing {

/// Interacting multiple models: indentation δ as a random walk of low (holding) or high (moving) intensity; each
/// reading z = h·δ + noise. A new touch starts from the prior of `configure`. All results are finite for any input.
class FYD_API IndentationFilter {
 public:
  struct Measurement {
    double z_mm = 0.0;
    double h = 0.0;         ///< share of the indentation this sensor sees
    double sigma_mm = 0.0;  ///< of z
    bool used = false;      ///< set by update: false when left out as an outlier
  };

  /// The start is the prior of a new touch, before its first reading; it takes effect with `restart`.
  void configure(double holding_mm_per_sqrt_s, double moving_mm_per_sqrt_s, double start_mm = 0.0,
                 double start_sigma_mm = kStartSigma_mm, double start_holding = 0.1);
  void restart();
  /// @param dt_s time since the last update; not positive or not finite: no time passes; beyond 1 s: 1 s
  void update(double dt_s, std::span<Measurement> measurements);

  [[nodiscard]] double value_mm() const { return value_; }
  [[nodiscard]] double sigma_mm() const;
  /// Probability that the finger holds still, 0…1.
  [[nodiscard]] double holding() const { return probability_[0]; }
  /// Smoothed square of (reading − expected)/σ: about 1 when sensors agree.
  [[nodiscard]] double disagreement() const { return disagreement_; }

  static constexpr double kStartSigma_mm = 6.0;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(modes_, probability_, value_, variance_, disagreement_, counter(left_out_in_a_row_));
  }

 private:
  struct Gaussian {
    double mean = 0.0;
    double variance = kStartSigma_mm * kStartSigma_mm;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(mean, variance);
    }
  };

  void mix(double dt_s);
  void combine();

  Gaussian prior_;
  double prior_holding_ = 0.1;                       // probability: a touch begins with a movement
  std::array<double, 2> process_noise_{1.0, 400.0};  // mm²/s: holding, moving
  std::array<Gaussian, 2> modes_{};                  // δ if holding, if moving
  std::array<double, 2> probability_{0.5, 0.5};      // of each mode
  double value_ = 0.0;                               // δ, both modes combined
  double variance_ = kStartSigma_mm * kStartSigma_mm;
  double disagreement_ = 1.0;
  int left_out_in_a_row_ = 0;
};

/// Later device code of the thesis' authors: a new value only when it moved < 2 mm, then 0.8 old + 0.2 new.
class FYD_API ThesisSmoother {
 public:
  void restart() { *this = {}; }
  double update(double value_mm);
  [[nodiscard]] double value_mm() const { return value_; }

  static constexpr double kGate_mm = 2.0;
  static constexpr double kOldShare = 0.8;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(value_, refused_, counter(refusals_), started_);
  }

 private:
  double value_ = 0.0;
  double refused_ = 0.0;  // last value the gate refused
  int refusals_ = 0;      // in a row, and within the gate of each other
  bool started_ = false;
};

}  // namespace fyd::sensing
