#include "core/scene/gesture/palpation.h"

#include <cmath>

#include "core/base/portable_math.h"

namespace fyd::scene {
namespace {

constexpr double kDebt_mJ = 2.0, kForgiven_s = 1.0;

Refusal refusalOfInputs(const PalpationInputs& inputs, double dt_s) {
  const Refusal plain = firstRefusal(dt_s, inputs.probe_mm, inputs.touch.normal);
  if (plain != Refusal::none) return plain;
  const bool numbers = std::isfinite(inputs.touch.depth_mm) && std::isfinite(inputs.touch.stiffness_N_per_mm) &&
                       std::isfinite(inputs.measured_N.value_or(0.0));
  return numbers && squared(inputs.touch.normal) > 0.0 ? Refusal::none : Refusal::not_a_number;
}

/// Grows by `steepness` at first and saturates at `most_N`.
double bent(double too_fast_mm_per_s, double steepness_Ns_per_mm, double most_N) {
  const double straight = steepness_Ns_per_mm * too_fast_mm_per_s;
  return straight > 0.0 ? most_N * (straight / (straight + most_N)) : 0.0;
}

}  // namespace

PalpatedSurface touchPlane(const PalpationParameters& parameters, const PlaneParameters& plane, const Vec3& probe_mm) {
  const Vec3 normal{plane.normal_x, plane.normal_y, plane.normal_z};
  const Vec3 from = probe_mm - Vec3{plane.x_mm, plane.y_mm, plane.z_mm};
  return {normal, -dot(unit(normal), from), parameters.stiffness_N_per_mm};
}

PalpationForce stepPalpation(const PalpationParameters& p, PalpationState& state, const PalpationInputs& inputs,
                             double dt_s) {
  PalpationForce out;
  out.refusal = refusalOfInputs(inputs, dt_s);
  if (out.refusal != Refusal::none) return out;
  const PalpatedSurface& touch = inputs.touch;
  const Vec3 n = unit(touch.normal);
  const double depth = std::max(0.0, touch.depth_mm), stiffness = std::max(0.0, touch.stiffness_N_per_mm);
  if (!state.known) state = {.known = true, .probe_mm = inputs.probe_mm, .depth_mm = depth};
  const Vec3 moved = inputs.probe_mm - state.probe_mm;
  const double stays = p.speed_time_constant_s > 0.0 ? math::exp(-dt_s / p.speed_time_constant_s) : 0.0;
  state.velocity_mm_per_s = stays * state.velocity_mm_per_s + ((1.0 - stays) / dt_s) * moved;
  state.taken_mJ -= dot(state.tangential_N, moved);
  if (state.taken_mJ < 0.0) state.taken_mJ *= math::exp(-dt_s / kForgiven_s);

  double normal_N = normalForce(depth, (depth - state.depth_mm) / dt_s, stiffness, p.damping_Ns_per_mm, p.most_force_N);
  double engaged_mm = depth;
  if (inputs.measured_N) {
    normal_N = std::clamp(*inputs.measured_N, 0.0, p.most_force_N);
    engaged_mm = std::max(engaged_mm, normal_N / p.stiffness_N_per_mm);
  }
  out.normal_N = normal_N * n;

  const Vec3 across = state.velocity_mm_per_s - dot(state.velocity_mm_per_s, n) * n;
  out.speed_mm_per_s = length(across);
  out.too_fast_mm_per_s = std::max(0.0, out.speed_mm_per_s - p.speed_limit_mm_per_s);
  // The smoothed speed changes sign later than the hand: scale the force down when it has given energy to the hand.
  const double trusted = std::clamp(1.0 + state.taken_mJ / kDebt_mJ, 0.0, 1.0);
  const double against = trusted * std::min(1.0, engaged_mm / p.engage_mm) *
                         bent(out.too_fast_mm_per_s, p.steepness_Ns_per_mm, p.most_tangential_N);
  if (against > 0.0) out.tangential_N = (-against / out.speed_mm_per_s) * across;
  out.touching = depth > 0.0 || normal_N > 0.0;
  out.force_N = out.normal_N + out.tangential_N;
  out.segment = forceSegment(inputs.probe_mm, out.force_N, p.segment_mm_per_N);
  state.probe_mm = inputs.probe_mm;
  state.depth_mm = depth;
  state.tangential_N = out.tangential_N;
  return out;
}

}  // namespace fyd::scene
