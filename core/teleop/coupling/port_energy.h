// Passivity observer and controller of one port: the work of a force held over each step, and a limit of the next
// force.
#pragma once

#include <algorithm>

#include "core/teleop/coupling/coupling.h"

namespace fyd::teleop {

/// The energy at one end of a coupling. A force held from one step to the next does exactly force · distance.
class PortEnergy {
 public:
  /// Call at each step, before the force of the next one is known.
  void observe(double time_s, double position_m) {
    if (begun_) {
      energy_J_ += force_N_ * (position_m - position_m_);
      step_s_ = std::clamp(time_s - time_s_, 0.0, kLongestStep_s);
    }
    begun_ = true;
    time_s_ = time_s;
    position_m_ = position_m;
  }

  /// A step whose state is no measurement: no force is held from it on, so none works until the next one.
  void refuse() { force_N_ = 0.0; }

  /// The force, reduced so that it gives back no more than was put in less a reserve for changes of the speed within
  /// the step.
  [[nodiscard]] double passive(double force_N, double velocity_m_per_s) {
    double out = force_N;
    const double comes_J = force_N * velocity_m_per_s * step_s_;
    const double may_come_J = energy_J_ > kReserve_J ? energy_J_ - kReserve_J : 0.0;
    if (comes_J < -may_come_J) {
      out = force_N * (may_come_J / -comes_J);
      dissipated_J_ += (out - force_N) * velocity_m_per_s * step_s_;
    }
    force_N_ = out;
    return out;
  }

  [[nodiscard]] double energy_J() const { return energy_J_; }
  [[nodiscard]] double dissipated_J() const { return dissipated_J_; }
  [[nodiscard]] double step_s() const { return step_s_; }

  static constexpr double kReserve_J = 0.3e-3;

 private:
  bool begun_ = false;
  double time_s_ = 0.0;
  double position_m_ = 0.0;
  double force_N_ = 0.0;
  double step_s_ = kUsualStep_s;
  double energy_J_ = 0.0;
  double dissipated_J_ = 0.0;
};

}  // namespace fyd::teleop
