// Learns how much stiffer or softer than its calibration the cloth under the finger is, from noisy readings.
//
// s = ln S is nearly constant during a touch; the reading's noise is not white but correlated over a time Tc.
// A Kalman–Bucy filter of s:
//
//   ṡ = (P/r)·(z − s),   Ṗ = q² − P²/r,   r = 2·Tc·v,   z = ln k̂ − ln law seen by the sensors
//
// v, the reading's variance, starts from the sensing's own sigma and is then learned from the readings'
// own scatter about their running mean; while the stretch moves, the unknown part of the sensors' lag is added to it.
//
// significantLogScale(): 0 until |s| exceeds 2.8σ, σ = √P; then all of s (faded in over 0.15 s) until |s| falls below
// 1σ. So noise causes no correction on a cloth that matches its calibration, one that does not is recognised within
// one or two seconds, and the result does not switch back and forth.
// Stability: may change
#pragma once

#include "core/base/api.h"

namespace fyd::control {

class FYD_API ScaleObserver {
 public:
  /// @param correlation_s Tc; not finite or ≤ 0 changes nothing
  void configure(double correlation_s);
  /// Back to the prior: s = 0 ± 0.25, about ± 25 % in S.
  void reset();
  /// A new touch, maybe elsewhere on the cloth: raises the variance of what was learned.
  void beginTouch();

  /// One reading of z. Values that are not finite, and dt ≤ 0, change nothing.
  /// @param relative_sigma of the reading, from the sensing; not finite or ≤ 0 counts as 7 %
  /// @param law_log ln law at the present stretch, to detect its motion
  void step(double z, double relative_sigma, double law_log, double dt_s);

  [[nodiscard]] double logScale() const { return log_scale_; }
  [[nodiscard]] double sigma() const;
  [[nodiscard]] double significantLogScale() const { return fade_in_ * log_scale_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(log_scale_, variance_, significant_, fade_in_, mean_z_, reading_variance_, slow_law_log_, slow_known_);
  }

 private:
  double correlation_s_ = 0.4;
  double log_scale_ = 0.0;        // s
  double variance_ = 0.0625;      // P
  bool significant_ = false;      // |s| is above its threshold in σ
  double fade_in_ = 0.0;          // 0…1: share of s in use
  double mean_z_ = 0.0;           // over kMeanTime_s
  double reading_variance_ = -1;  // v; negative until the first reading
  double slow_law_log_ = 0.0;     // law_log, low-passed over kMotionTime_s
  bool slow_known_ = false;
};

}  // namespace fyd::control
