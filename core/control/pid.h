// PID controller whose output stays finite and within its limits for any gains, times and measurements.
//
//   u = kp·e + I − kd·ẏ,   İ = ki·e,   e = setpoint − measurement,   ẏ low-passed with time constant Tf
//
// - Derivative of the measurement y, not of the error: a step of the target gives no kick.
// - Conditional anti-windup: at a limit the integrator stops while the error pushes outward; as soon as it points
//   inward the integrator returns to the limit's edge at once, so nothing has to unwind.
// - Bumpless: new gains take effect without a step of u (the integrator takes up the difference).
// - Limits on u and on its rate; NaN, infinity, dt ≤ 0 leave everything as it was; a larger dt counts as the maximum.
// - Gains below 0 or not finite count as 0; gains up to 1e12, which recordings of earlier programs may have, give a bang-bang
//   between the limits, never an overflow.
// Stability: may change
#pragma once

#include "core/base/api.h"

namespace fyd::control {

struct PidGains {
  double kp = 0.0;                   ///< unit of u per unit of e
  double ki = 0.0;                   ///< unit of u per unit of e and second
  double kd = 0.0;                   ///< unit of u per unit of e per second
  double derivative_filter_s = 0.1;  ///< > 0
};

struct PidLimits {
  double minimum = -1.0;
  double maximum = 1.0;
  double rate_per_s = 1e300;  ///< fastest change of u

  template <class Archive>
  void serialize(Archive& archive) {
    archive(minimum, maximum, rate_per_s);
  }
};

class FYD_API Pid {
 public:
  explicit Pid(const PidGains& gains = {}, const PidLimits& limits = {}, double maximum_step_s = 0.02);

  /// Takes effect at the next step, bumplessly.
  void setGains(const PidGains& gains);
  /// NaN or minimum > maximum: ignored.
  void setLimits(const PidLimits& limits);

  /// One step.
  /// @param integrate false holds the integrator, for a measurement that does not yet reflect the output
  /// @return u, always finite and within the limits
  double step(double setpoint, double measurement, double dt_s, bool integrate = true);

  /// Forgets error and derivative; the integrator is set so that u starts at `output`.
  void reset(double output = 0.0);

  [[nodiscard]] double output() const { return output_; }
  [[nodiscard]] double integral() const { return integral_; }
  /// u touches a limit of value (not of rate).
  [[nodiscard]] bool saturated() const { return saturated_; }

  /// Without the gains.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(limits_, integral_, derivative_, last_error_, last_measurement_, output_, started_, saturated_);
  }

 private:
  void integrate(double error, double rest, double dt_s);  // rest: the proportional and derivative parts

  PidGains gains_;
  PidLimits limits_;
  double maximum_step_s_;
  double integral_ = 0.0;
  double derivative_ = 0.0;  // filtered dy/dt
  double last_error_ = 0.0;
  double last_measurement_ = 0.0;
  double output_ = 0.0;
  bool started_ = false;
  bool saturated_ = false;
};

}  // namespace fyd::control
