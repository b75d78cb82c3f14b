// How much of the measured difference between cloth and law the loop may correct.
//
// s, the logarithm of measured stiffness over calibrated law (scale_observer.h), is the cloth's own difference from its
// calibration plus the measurement's lasting error. The second part cannot be averaged away, so:
//
//   excess:   corrected = sign(s)·max(0, |s| − ln(1 + bias))
//   bounded:  corrected = sign(s)·min(|s|, 2·max(0, |s| − ln(1 + bias)))
//
// While the measurement is off by no more than `bias`, the cloth's own difference has the sign of s and at least the
// size of the excess, so that correcting by up to twice the excess never leaves the loop further from the target than
// the law alone would be. `excess` is what programs before `bounded` did; it leaves `bias` of every cloth uncorrected.
//
// A difference beyond `limit` is more than a cloth of this calibration can have: law and measurement contradict each
// other, one of them is wrong, and the law alone is used until they agree again.
// Stability: may change
#pragma once

#include "core/base/api.h"
#include "core/control/control_parameters.h"

namespace fyd::control {

class FYD_API ScaleTrust {
 public:
  /// @param bias relative error of the measurement that may last, 0.1 for 10 %; not finite or below 0 counts as 0
  /// @param limit largest relative correction, 0.35 for 35 %; not finite or below 0 counts as 0
  void configure(double bias, double limit, CorrectionRule rule = CorrectionRule::bounded);
  void reset();

  /// @param log_scale s; not finite counts as 0
  void step(double log_scale, double dt_s);

  /// Logarithm of the scale that the loop may use; within ± ln(1 + limit).
  [[nodiscard]] double logScale() const { return trust_ * corrected_; }
  /// Law and measurement have disagreed for so long (1 s) that the law alone is used.
  [[nodiscard]] bool contradicted() const { return contradicted_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(corrected_, trust_, contradicted_);
  }

 private:
  double bias_log_ = 0.0;
  double limit_log_ = 0.0;
  CorrectionRule rule_ = CorrectionRule::bounded;
  double corrected_ = 0.0;  // logarithm
  double trust_ = 1.0;      // 0…1: share of the correction in use
  bool contradicted_ = false;
};

}  // namespace fyd::control
