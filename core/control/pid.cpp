#include "core/control/pid.h"

#include <algorithm>
#include <cmath>

namespace fyd::control {
namespace {

// Far beyond any meaningful stiffness, angle or gain; products of three of these stay finite.
constexpr double kLargest = 1e12;

double gainOrZero(double gain) { return gain > 0 && std::isfinite(gain) ? std::min(gain, kLargest) : 0.0; }

PidGains sane(const PidGains& gains) {
  const double filter = gains.derivative_filter_s;
  return {gainOrZero(gains.kp), gainOrZero(gains.ki), gainOrZero(gains.kd),
          filter > 0 && std::isfinite(filter) ? filter : PidGains{}.derivative_filter_s};
}

bool usable(const PidLimits& limits) {
  return std::isfinite(limits.minimum) && std::isfinite(limits.maximum) && limits.minimum <= limits.maximum &&
         limits.rate_per_s >= 0;
}

}  // namespace

Pid::Pid(const PidGains& gains, const PidLimits& limits, double maximum_step_s)
    : gains_(sane(gains)), maximum_step_s_(maximum_step_s) {
  setLimits(limits);
  output_ = std::clamp(0.0, limits_.minimum, limits_.maximum);
}

void Pid::setGains(const PidGains& gains) {
  const PidGains next = sane(gains);
  const double taken_up = integral_ + (gains_.kp - next.kp) * last_error_ - (gains_.kd - next.kd) * derivative_;
  // Very large gains must not leave an integral beyond the limits.
  integral_ = std::clamp(taken_up, std::min(limits_.minimum, integral_), std::max(limits_.maximum, integral_));
  gains_ = next;
}

void Pid::setLimits(const PidLimits& limits) {
  if (usable(limits)) limits_ = limits;
}

double Pid::step(double setpoint, double measurement, double dt_s, bool integrate_now) {
  if (!std::isfinite(setpoint) || !std::isfinite(measurement) || !(dt_s > 0)) {
    output_ = std::clamp(output_, limits_.minimum, limits_.maximum);
    return output_;
  }
  const double dt = std::min(dt_s, maximum_step_s_);
  const double y = std::clamp(measurement, -kLargest, kLargest);
  const double error = std::clamp(setpoint, -kLargest, kLargest) - y;
  if (!started_) {
    started_ = true;
    last_measurement_ = y;
  }
  // Low-passed derivative without a division by dt, which may be arbitrarily small.
  derivative_ += ((y - last_measurement_) - derivative_ * dt) / (gains_.derivative_filter_s + dt);
  last_measurement_ = y;
  last_error_ = error;

  const double rest = gains_.kp * error - gains_.kd * derivative_;
  if (integrate_now) integrate(error, rest, dt);
  const double wanted = rest + integral_;
  const double limited = std::clamp(wanted, limits_.minimum, limits_.maximum);
  saturated_ = limited != wanted;
  const double reach = limits_.rate_per_s * dt;
  output_ = std::clamp(std::clamp(limited, output_ - reach, output_ + reach), limits_.minimum, limits_.maximum);
  return output_;
}

void Pid::integrate(double error, double rest, double dt) {
  const double upper = limits_.maximum - rest, lower = limits_.minimum - rest;  // edges as the integrator sees them
  const double reach = limits_.rate_per_s * dt;
  if (error > 0) {
    if (integral_ < lower) integral_ = lower;  // at the lower limit with a positive error: nothing to unwind
    if (rest + integral_ - output_ > reach) return;
    integral_ = std::max(integral_, std::min(integral_ + gains_.ki * error * dt, upper));
  } else if (error < 0) {
    if (integral_ > upper) integral_ = upper;
    if (output_ - rest - integral_ > reach) return;
    integral_ = std::min(integral_, std::max(integral_ + gains_.ki * error * dt, lower));
  }
}

void Pid::reset(double output) {
  integral_ = std::isfinite(output) ? std::clamp(output, limits_.minimum, limits_.maximum) : 0.0;
  output_ = std::clamp(integral_, limits_.minimum, limits_.maximum);
  derivative_ = 0.0;
  last_error_ = 0.0;
  started_ = false;
  saturated_ = false;
}

}  // namespace fyd::control
