#include "core/teleop/coupling/spring_coupling.h"

#include <algorithm>
#include <cmath>

namespace fyd::teleop {

void SpringEnd::receive(const CouplingMessage& message) {
  if (!std::isfinite(message.date_s) || !isPlace(message.position_m)) return;
  if (heard_ && !(message.date_s > heard_date_s_)) return;
  const double since_s = heard_ ? message.date_s - heard_date_s_ : 0.0;
  heard_ = true;
  heard_date_s_ = message.date_s;
  other_m_ = message.position_m;
  if (!std::isfinite(message.energy_J)) return;
  // Less than before: the other end has linked anew and counts from nothing.
  if (!told_J_ || message.energy_J < *told_J_) {
    told_J_ = message.energy_J;
    return;
  }
  const double more_J = std::min(message.energy_J - *told_J_, kMostPower_W * std::min(since_s, 1.0));
  *told_J_ += more_J;
  other_energy_J_ += more_J;
}

double SpringEnd::step(const EndState& state) {
  if (!isSound(state)) {
    force_N_ = 0.0;
    return 0.0;
  }
  const double dt = begun_ ? std::clamp(state.time_s - time_s_, 0.0, kLongestStep_s) : kUsualStep_s;
  if (begun_) {
    const double moved_J = force_N_ * (state.position_m - position_m_);
    (moved_J > 0.0 ? in_J_ : out_J_) += std::abs(moved_J);
  }
  begun_ = true;
  time_s_ = state.time_s;
  position_m_ = state.position_m;
  if (!heard_) {
    force_N_ = 0.0;
    return 0.0;
  }
  // At both ends the spring pulls to the other end. The returned force pushes the hand back; at the far end it drives.
  force_N_ = settings_.stiffness_N_per_m * (state.position_m - other_m_);
  const double v = state.velocity_m_per_s;
  if (observed_ && dt > 0.0 && v != 0.0) {
    const double more_J = out_J_ + std::max(0.0, -force_N_ * v * dt) - other_energy_J_;
    if (more_J > 0.0 && force_N_ * v < 0.0) {
      const double wanted_N = more_J / (v * dt);  // a damper: along the velocity
      const double before_N = force_N_;
      force_N_ += std::clamp(wanted_N, -std::abs(force_N_), std::abs(force_N_));
      dissipated_J_ += (force_N_ - before_N) * v * dt;
    }
  }
  force_N_ = std::clamp(force_N_, -settings_.most_force_N, settings_.most_force_N);
  if (side_ == Side::hand) return force_N_;
  return std::clamp(-force_N_ - settings_.damping_N_s_per_m * v, -settings_.most_force_N, settings_.most_force_N);
}

CouplingMessage SpringEnd::message() const { return {.date_s = time_s_, .position_m = position_m_, .energy_J = in_J_}; }

CouplingTelemetry SpringEnd::telemetry() const { return {.energy_J = in_J_ - out_J_, .dissipated_J = dissipated_J_}; }

}  // namespace fyd::teleop
