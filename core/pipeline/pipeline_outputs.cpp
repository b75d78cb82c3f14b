// The step's second half: what goes out (motion, scene, coupling, control, texture, telemetry). The first half is
// pipeline.cpp.
#include <algorithm>
#include <cmath>

#include "core/pipeline/pipeline.h"
#include "core/scene/felt_scene.h"

namespace fyd::pipeline {
namespace {

template <class T>
double ageMs(const Timed<T>& input, Instant now) {
  return input.count == 0 ? kNone : toMilliseconds(input.age(now));
}

}  // namespace

bool Pipeline::rendering(const Inputs& inputs) const {
  return safety_.state() == SafetyState::active && inputs.robot.phase != LinkPhase::paused;
}

double Pipeline::target() const {
  return target_by_hand_ ? parameters_.step.hand_target_N_per_mm : coupled_.target_N_per_mm;
}

void Pipeline::stepMotion(const Inputs& inputs) {
  const StepParameters& step = parameters_.step;
  outputs_.touch = motion_.step({.elapsed = elapsed_,
                                 .enabled = rendering(inputs),
                                 .contact = indent_.touched,
                                 .finger_x_mm = contact_.x_mm,
                                 .finger_y_mm = contact_.y_mm,
                                 .indentation_mm = indent_.available ? indent_.indentation_mm : kNone,
                                 .force_N = force_N_.value,
                                 .finger_taken = inputs.finger.taken,
                                 .absolute = step.absolute_motion,
                                 .scale = step.motion_scale,
                                 .depth_scale = step.motion_depth_scale,
                                 .speed_limit_mm_s = step.motion_speed_limit_mm_s});
}

void Pipeline::stepScene(const Inputs& inputs) {
  if (!scene_) return;
  const Vec3& touch_mm = outputs_.touch.position_mm;
  const scene::SceneTouch& felt = scene_->step({touch_mm.x, touch_mm.y, kRobotTravelForDepth * touch_mm.z},
                                               toSeconds(inputs.now.time_since_epoch()));
  of_scene_ = {.value = {.stiffness_N_per_mm = felt.stiffness_N_per_mm,
                         .position_mm = felt.touching ? felt.proxy_mm : scene_->probe_mm(),
                         .force_N = felt.force_N.norm()},
               .taken = inputs.now,
               .count = steps_};
}

const Timed<RobotState>& Pipeline::told(const Inputs& inputs) const { return scene_ ? of_scene_ : inputs.robot.state; }

void Pipeline::stepCoupling(const Inputs& inputs) {
  const RobotState& robot = told(inputs).value;
  coupled_ = coupling_.step(
      {.choice = parameters_.step.coupling,
       .elapsed_s = toSeconds(elapsed_),
       .led = rendering(inputs) && !target_by_hand_,
       .robot = {.stiffness_N_per_mm = robot.stiffness_N_per_mm,
                 .force_N = robot.force_N,
                 .position_mm = robot.position_mm},
       .robot_count = told(inputs).count,
       .touched = indent_.touched,
       .indentation_mm = indent_.available ? indent_.indentation_mm : kNone,
       .force_N = force_N_.count > 0 ? force_N_.value : kNone,
       .cloth_N_per_mm = rollers_.valid ? controller_.law().stiffness_N_per_mm(rollers_.stretch_deg).value : kNone,
       .least_indentation_mm = parameters_.sensing.stiffness.minimum_indentation_mm});
}

/// Only contact mode tells places apart; what it last said must not go on dividing the targets of another mode.
double Pipeline::placeFactor() const {
  const bool places = parameters_.sensing.indentation.mode == sensing::IndentationMode::contact;
  return places ? indentation_.placeFactor() : 1.0;
}

void Pipeline::stepControl(const Inputs& inputs) {
  const bool enabled = rendering(inputs);
  const bool robot_sets = enabled && robot_sets_reference_ && inputs.robot.motor_reference.count > 0;
  control_ = controller_.step({.now = inputs.now,
                               .target_N_per_mm = target(),
                               .measured_N_per_mm = stiff_.stiffness_N_per_mm,
                               .measured_sigma_N_per_mm = stiff_.sigma_N_per_mm,
                               .place_factor = placeFactor(),
                               .observable = stiff_.observable,
                               .measured_angle_deg = rollers_.stretch_deg,
                               .measured_angle_known = rollers_.valid,
                               .enabled = enabled && !robot_sets});
  if (robot_sets) {
    followRobotReference(inputs.robot.motor_reference.value);
  } else if (enabled) {
    // The printed PI sets its reference at once; its rate is no part of it.
    const bool at_once = parameters_.control.mode == control::ControlMode::thesis;
    stretch_deg_ = at_once ? control_.stretch_angle_deg : approach(stretch_deg_, control_.stretch_angle_deg);
    translation_deg_ = approach(translation_deg_, 0.0);
  }
  if (control_.target_clamped && !target_was_clamped_) {
    report({.kind = EventKind::target_clamped, .value = control_.reachable_target_N_per_mm});
  }
  target_was_clamped_ = control_.target_clamped;
  if (enabled && control_.contradiction_begins) {
    report({.kind = EventKind::law_contradicted, .value = control_.measured_scale});
  }
  outputs_.motors.active = safety_.state() == SafetyState::active || safety_.state() == SafetyState::held;
  mixing_.mix(stretch_deg_, translation_deg_, outputs_.motors);
}

double Pipeline::approach(double from_deg, double to_deg) const {
  constexpr double kRounding = 1.0 + 1e-9;  // the controller keeps to the same rate
  const double furthest = parameters_.control.rate_limit_deg_per_s * toSeconds(elapsed_);
  if (std::abs(to_deg - from_deg) <= kRounding * furthest) return to_deg;
  return from_deg + std::copysign(furthest, to_deg - from_deg);
}

void Pipeline::followRobotReference(const RobotMotorReference& reference) {
  if (!std::isfinite(reference.first_ticks) || !std::isfinite(reference.second_ticks)) return;
  const control::ControlParameters& limits = parameters_.control;
  const double stretch = 0.5 * (reference.first_ticks - reference.second_ticks) / control::kTicksPerDegree;
  const double translation = 0.5 * (reference.first_ticks + reference.second_ticks) / control::kTicksPerDegree;
  stretch_deg_ = approach(stretch_deg_, std::clamp(stretch, limits.travel_minimum_deg, limits.travel_maximum_deg));
  translation_deg_ =
      approach(translation_deg_, std::clamp(translation, -limits.motor_limit_deg, limits.motor_limit_deg));
}

void Pipeline::stepTexture(const Inputs& inputs) {
  const control::MotorFeedback& motors = inputs.motors.value;
  const auto& shares = motors.position_duty_percent;
  const double share = !motors.position_duty_known                 ? kNone
                       : std::abs(shares[0]) > std::abs(shares[1]) ? shares[0]
                                                                   : shares[1];
  renderer_.setStretch(rollers_.valid ? rollers_.stretch_deg : kNone);
  if (scene_) {
    texture_ = renderer_.stepVirtual(scene_->texture_g(), share);
  } else if (surface_ && inputs.robot.phase == LinkPhase::none) {
    const double speed = indent_.touched ? finger_speed_.at(inputs.now) : 0.0;
    texture_ = renderer_.stepVirtual(surface_->step(speed, force_N_.value), share);
  } else {
    texture_ = renderer_.step(inputs.now, inputs.robot.accelerations.view(), share);
  }
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    const double wanted = texture_.duty_percent[i];
    const double duty = rendering(inputs) && std::isfinite(wanted) ? wanted : 0.0;
    const double used =
        motors.position_duty_known && std::isfinite(shares[i]) ? std::clamp(shares[i], -100.0, 100.0) : 0.0;
    outputs_.motors.vibration_duty_percent[i] = std::clamp(duty, -100.0 - used, 100.0 - used);
  }
  const double stretch_deg = rollers_.valid ? rollers_.stretch_deg : kNone;
  finger_prediction_.configure(parameters_.texture.plant, stretch_deg);
  finger_prediction_.step(outputs_.motors.vibration_duty_percent, rendering(inputs) ? texture_.signal_g : 0.0,
                          rendering(inputs) && texture_.limited);
}

void Pipeline::writeTelemetry(const Inputs& inputs) {
  TelemetrySample& out = outputs_.telemetry;
  out = {};
  out.now = inputs.now;
  out.step = steps_;
  out.state = safety_.state();
  out.fault = safety_.state() == SafetyState::held ? safety_.heldBecause() : InputHealth::first(faults_);
  out.link = inputs.robot.phase;
  out.contact = indent_.touched;
  if (indent_.touched) {
    out.finger_x_mm = contact_.x_mm;
    out.finger_y_mm = contact_.y_mm;
  }
  if (inputs.finger.count > 0) out.finger_area_px = inputs.finger.value.area_px;
  if (indent_.available) {
    out.indentation_mm = indent_.indentation_mm;
    out.indentation_sigma_mm = indent_.sigma_mm;
  }
  out.force_N = force_N_.count > 0 ? force_N_.value : kNone;
  out.stiffness_N_per_mm = stiff_.known ? stiff_.stiffness_N_per_mm : kNone;
  out.stiffness_observable = stiff_.observable;
  out.stiffness_place_factor = indentation_.placeFactor();
  const Timed<RobotState>& robot = told(inputs);
  if (robot.count > 0) {
    out.robot_stiffness_N_per_mm = robot.value.stiffness_N_per_mm;
    out.robot_force_N = robot.value.force_N;
    out.robot_x_mm = robot.value.position_mm.x;
    out.robot_y_mm = robot.value.position_mm.y;
    out.robot_z_mm = robot.value.position_mm.z;
  }
  out.target_N_per_mm = target();
  out.reachable_target_N_per_mm = control_.reachable_target_N_per_mm;
  out.target_clamped = control_.target_clamped;
  out.finger_energy_mJ = coupled_.finger_energy_mJ;
  out.coupling_withheld_mJ = coupled_.withheld_mJ;
  out.stretch_reference_deg = stretch_deg_;
  if (rollers_.valid) {
    out.stretch_measured_deg = rollers_.stretch_deg;
    out.translation_measured_deg = rollers_.translation_deg;
  }
  if (!inputs.robot.accelerations.empty()) {
    newest_acceleration_g_ = inputs.robot.accelerations[inputs.robot.accelerations.size() - 1].acceleration_g;
  }
  if (inputs.robot.phase == LinkPhase::running) {
    out.acceleration_x_g = newest_acceleration_g_.x;
    out.acceleration_y_g = newest_acceleration_g_.y;
    out.acceleration_z_g = newest_acceleration_g_.z;
  }
  out.texture_signal_g = texture_.signal_g;
  out.vibration_duty_percent = outputs_.motors.vibration_duty_percent[0];
  out.vibration_clipped = static_cast<double>(texture_.clipped);
  const texture::FingerFigures felt = finger_prediction_.figures();
  out.felt_acceleration_g = felt.acceleration_g;
  out.felt_level_dB = felt.level_dB;
  out.felt_out_of_reach = felt.out_of_reach ? 1.0 : 0.0;
  out.vibration_rms_percent = felt.duty_rms_percent;
  out.vibration_dead_share = felt.dead_share;
  out.vibration_clipped_share = felt.clipped_share;
  out.touch_x_mm = outputs_.touch.position_mm.x;
  out.touch_y_mm = outputs_.touch.position_mm.y;
  out.touch_z_mm = outputs_.touch.position_mm.z;
  out.finger_age_ms = ageMs(inputs.finger, inputs.now);
  out.ir_age_ms = ageMs(inputs.ir, inputs.now);
  out.bridge_age_ms = ageMs(inputs.bridge, inputs.now);
  out.motors_age_ms = ageMs(inputs.motors, inputs.now);
  out.robot_age_ms = ageMs(robot, inputs.now);
  out.missed_cycles = static_cast<double>(inputs.missed_cycles);
}

}  // namespace fyd::pipeline
