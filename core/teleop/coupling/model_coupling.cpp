#include "core/teleop/coupling/model_coupling.h"

#include <algorithm>
#include <cmath>

namespace fyd::teleop {
namespace {

/// Whether a message is newer than the last and its values are possible.
bool takes(const CouplingMessage& message, bool heard, const CouplingMessage& newest) {
  if (!std::isfinite(message.date_s) || !isPlace(message.position_m)) return false;
  if (heard && !(message.date_s > newest.date_s)) return false;
  return !message.knows_surface ||
         (isPlace(message.surface_m) && message.stiffness_N_per_m >= SurfaceEstimator::kLeast_N_per_m &&
          message.stiffness_N_per_m <= SurfaceEstimator::kMost_N_per_m);
}

}  // namespace

void ModelHandEnd::receive(const CouplingMessage& message) {
  if (!takes(message, heard_, newest_)) return;
  heard_ = true;
  newest_ = message;
}

void ModelHandEnd::follow(double position_m, double dt) {
  if (!heard_) return;
  if (!newest_.knows_surface) {
    if (!has_surface_) return;
    surface_m_ += kSinking_m_per_s * dt;
    if (surface_m_ >= position_m) has_surface_ = false;
    return;
  }
  if (!has_surface_) {
    has_surface_ = true;
    surface_m_ = std::max(newest_.surface_m, position_m);
    stiffness_ = newest_.stiffness_N_per_m;
    return;
  }
  const bool pressed = position_m > surface_m_;
  if (newest_.surface_m > surface_m_) {
    surface_m_ = pressed ? std::min(newest_.surface_m, surface_m_ + kSinking_m_per_s * dt) : newest_.surface_m;
  } else if (!pressed) {
    surface_m_ = std::max(newest_.surface_m, position_m);
  }
  if (!pressed) {
    stiffness_ = newest_.stiffness_N_per_m;
  } else if (newest_.stiffness_N_per_m < stiffness_) {
    stiffness_ += (newest_.stiffness_N_per_m - stiffness_) * std::min(1.0, dt / kSofteningTime_s);
  }
}

double ModelHandEnd::step(const EndState& state) {
  if (!isSound(state)) {
    port_.refuse();
    return 0.0;
  }
  port_.observe(state.time_s, state.position_m);
  time_s_ = state.time_s;
  position_m_ = state.position_m;
  const double dt = std::clamp(port_.step_s(), 0.0, kLongestStep_s);
  follow(state.position_m, dt);
  double force_N = 0.0;
  if (has_surface_) {
    // Half a step ahead: the hand's mean position while this force is held.
    const double deep_m = state.position_m + 0.5 * dt * state.velocity_m_per_s - surface_m_;
    const double damping = std::max(2.0 * kDampingRatio * std::sqrt(stiffness_), stiffness_ * dt);
    if (deep_m > 0.0) force_N = std::max(0.0, stiffness_ * deep_m + damping * state.velocity_m_per_s);
  }
  return port_.passive(std::min(force_N, settings_.most_force_N), state.velocity_m_per_s);
}

CouplingMessage ModelHandEnd::message() const { return {.date_s = time_s_, .position_m = position_m_}; }

CouplingTelemetry ModelHandEnd::telemetry() const {
  return {.energy_J = port_.energy_J(), .dissipated_J = port_.dissipated_J()};
}

void ModelFarEnd::receive(const CouplingMessage& message) {
  if (!takes(message, heard_, newest_)) return;
  heard_ = true;
  newest_ = message;
}

double ModelFarEnd::step(const EndState& state) {
  if (!isSound(state)) return 0.0;
  time_s_ = state.time_s;
  position_m_ = state.position_m;
  estimator_.step(state.position_m, state.velocity_m_per_s, state.measured_N);
  if (!heard_) return 0.0;
  const double force_N = settings_.stiffness_N_per_m * (newest_.position_m - state.position_m) -
                         settings_.damping_N_s_per_m * state.velocity_m_per_s;
  return std::clamp(force_N, -settings_.most_force_N, settings_.most_force_N);
}

CouplingMessage ModelFarEnd::message() const {
  return {.date_s = time_s_,
          .position_m = position_m_,
          .energy_J = 0.0,
          .touching = estimator_.touching(),
          .knows_surface = estimator_.known(),
          .surface_m = estimator_.surface_m(),
          .stiffness_N_per_m = estimator_.stiffness_N_per_m()};
}

}  // namespace fyd::teleop
