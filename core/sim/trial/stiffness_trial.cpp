#include "core/sim/trial/stiffness_trial.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/control/static_law.h"
#include "core/pipeline/tune_sample.h"
#include "core/sim/cloth/cloth.h"
#include "core/sim/touchpad/lockstep.h"

namespace fyd::sim {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kBand = 0.05;
constexpr double kSwing = 0.03;
constexpr int kMostSwings = 3;
constexpr double kLongestStart_s = 2.0;  // for the inputs to become complete

LockstepOptions optionsOf(const StiffnessTrial& trial) {
  LockstepOptions options;
  options.parameters = trial.parameters;
  options.parameters.step.hand_target_N_per_mm = trial.target_N_per_mm;
  options.sim = trial.sim;
  options.finger = FingerPath::constant(trial.x_mm, trial.y_mm, trial.press_mm);
  options.draw_pictures = false;
  options.robot_stiffness_N_per_mm = kNone;
  return options;
}

/// Steps until the pipeline is Active. @return false when its inputs never became complete
bool engage(Lockstep& lockstep) {
  while (lockstep.time_s() < kLongestStart_s) {
    const pipeline::SafetyState state = lockstep.step().telemetry.state;
    if (state == pipeline::SafetyState::active) return true;
    if (state == pipeline::SafetyState::ready) (void)lockstep.next.commands.push({pipeline::OperatorAction::arm});
  }
  return false;
}

TrialPoint pointOf(Lockstep& lockstep, double since_s) {
  const WorldSnapshot truth = lockstep.world().truth();
  const pipeline::TelemetrySample& telemetry = lockstep.outputs().telemetry;
  return {lockstep.time_s() - since_s, truth.stiffness_N_per_mm,
          telemetry.stiffness_observable ? telemetry.stiffness_N_per_mm : kNone, truth.angle_deg};
}

TrialResult judge(const std::vector<TrialPoint>& course, double target) {
  TrialResult result;
  const double side = target >= course.front().true_N_per_mm ? 1.0 : -1.0;
  result.settling_s = 0.0;
  for (const TrialPoint& point : course) {
    const double off = point.true_N_per_mm / target - 1;
    result.overshoot_percent = std::max(result.overshoot_percent, 100 * side * off);
    if (std::abs(off) > kBand)
      result.settling_s = kNone;
    else if (std::isnan(result.settling_s))
      result.settling_s = point.time_s;
  }
  double lowest_deg = std::numeric_limits<double>::infinity(), highest_deg = -lowest_deg;
  const std::size_t last_quarter = course.size() - std::max<std::size_t>(1, course.size() / 4);
  const auto count = static_cast<double>(course.size() - last_quarter);
  for (std::size_t i = last_quarter; i < course.size(); ++i) {
    const TrialPoint& point = course[i];
    result.steady_error_percent += 100 * std::abs(point.true_N_per_mm / target - 1) / count;
    result.final_true_N_per_mm += point.true_N_per_mm / count;
    result.final_stretch_deg += point.stretch_deg / count;
    lowest_deg = std::min(lowest_deg, point.stretch_deg);
    highest_deg = std::max(highest_deg, point.stretch_deg);
  }
  result.stretch_swing_deg = highest_deg - lowest_deg;
  return result;
}

}  // namespace

bool isStable(const std::vector<double>& stiffness) {
  if (std::any_of(stiffness.begin(), stiffness.end(), [](double k) { return !std::isfinite(k); })) return false;
  const auto begin = stiffness.begin() + static_cast<std::ptrdiff_t>(stiffness.size() / 2);
  if (begin == stiffness.end()) return true;
  double sum = 0.0;
  for (auto k = begin; k != stiffness.end(); ++k) sum += *k;
  const double threshold = kSwing * std::abs(sum) / static_cast<double>(stiffness.end() - begin);
  // Turning points: the course departs from its last extreme by more than the threshold.
  int swings = 0, direction = 0;
  double lowest = *begin, highest = *begin;
  for (auto k = begin; k != stiffness.end(); ++k) {
    lowest = std::min(lowest, *k);
    highest = std::max(highest, *k);
    if (direction <= 0 && *k > lowest + threshold) {
      direction = 1;
      ++swings;
      highest = *k;
    } else if (direction >= 0 && *k < highest - threshold) {
      direction = -1;
      ++swings;
      lowest = *k;
    }
  }
  return swings <= kMostSwings;
}

TrialResult runTrial(const StiffnessTrial& trial, std::vector<TrialPoint>* course) {
  Lockstep lockstep(optionsOf(trial));
  std::vector<TrialPoint> points;
  if (!engage(lockstep)) {
    TrialResult never;
    never.settling_s = never.steady_error_percent = never.final_true_N_per_mm = kNone;
    return never;
  }
  const double start_s = lockstep.time_s();
  points.reserve(static_cast<std::size_t>(trial.duration_s * 1e3) + 1);
  points.push_back(pointOf(lockstep, start_s));
  lockstep.run(trial.duration_s, [&](const pipeline::Outputs&) { points.push_back(pointOf(lockstep, start_s)); });

  TrialResult result = judge(points, trial.target_N_per_mm);
  std::vector<double> stiffness;
  stiffness.reserve(points.size());
  for (const TrialPoint& point : points) stiffness.push_back(point.true_N_per_mm);
  const pipeline::TelemetrySample& last = lockstep.outputs().telemetry;
  // A loop that left Active is not stable: the stiffness is no longer controlled.
  result.stable = isStable(stiffness) && last.state == pipeline::SafetyState::active;
  result.target_clamped = last.target_clamped;
  result.reachable_target_N_per_mm = last.reachable_target_N_per_mm;
  constexpr double kAtLimit_deg = 0.05;
  result.at_limit = last.stretch_reference_deg <= trial.parameters.control.travel_minimum_deg + kAtLimit_deg ||
                    last.stretch_reference_deg >= trial.parameters.control.travel_maximum_deg - kAtLimit_deg;
  const Cloth cloth(trial.sim);
  const FingerState finger{.x_mm = trial.x_mm, .y_mm = trial.y_mm, .indentation_mm = trial.press_mm, .lifted = false};
  const control::StaticLaw law(trial.parameters.control);
  result.reachable = trial.target_N_per_mm >= cloth.stiffness(law.minimumAngle_deg(), finger) &&
                     trial.target_N_per_mm <= cloth.stiffness(law.maximumAngle_deg(), finger);
  if (course != nullptr) *course = std::move(points);
  return result;
}

std::vector<control::TuneSample> recordExcitation(const StiffnessTrial& trial, const control::TuneProgress& progress) {
  constexpr int kSlices = 120;
  LockstepOptions options = optionsOf(trial);
  Lockstep lockstep(options);
  std::vector<control::TuneSample> recording;
  control::MotorMixing mixing(trial.parameters.control);
  control::MotorCommand command{.active = true};
  const auto each = [&](const pipeline::Outputs& outputs) {
    const pipeline::TelemetrySample& sample = outputs.telemetry;
    // The pipeline stays unarmed and only senses; the excitation drives the rollers.
    mixing.mix(control::excitationAngle_deg(lockstep.time_s(), trial.parameters.control), 0.0, command);
    lockstep.world().command(command);
    if (std::isnan(sample.stretch_measured_deg)) return;
    recording.push_back(pipeline::tuneSampleOf(sample, lockstep.time_s()));
  };
  for (int slice = 0; slice < kSlices; ++slice) {
    if (progress && !progress(static_cast<double>(slice) / kSlices)) break;
    lockstep.run(control::kExcitation_s / kSlices, each);
  }
  return recording;
}

void useThesisController(control::ControlParameters& parameters) {
  parameters.mode = control::ControlMode::thesis;
  parameters.law = control::StaticLawKind::thesis;
}

void scaleNoise(SimParameters& sim, double factor) {
  sim.ir_noise_mV = std::clamp(sim.ir_noise_mV * factor, 0.0, 200.0);
  sim.bridge_noise_mV_per_V = std::clamp(sim.bridge_noise_mV_per_V * factor, 0.0, 0.1);
  sim.camera_noise = std::clamp(sim.camera_noise * factor, 0.0, 30.0);
}

void delaySensors(SimParameters& sim, double delay_ms) {
  sim.ir_delay_ms = sim.bridge_delay_ms = sim.encoder_delay_ms = sim.camera_delay_ms = std::clamp(delay_ms, 0.0, 500.0);
}

}  // namespace fyd::sim
