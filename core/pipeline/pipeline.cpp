#include "core/pipeline/pipeline.h"

#include <algorithm>
#include <cmath>

namespace fyd::pipeline {
namespace {

constexpr Duration kLongestGap = std::chrono::milliseconds(20);
constexpr double kMostMissedPerSecond = 0.05 * 1000.0;
constexpr double kVibrationStep = 0.1;  // of the robot operator's keys (fact sheet §3)

template <class T>
double ageMs(const Timed<T>& input, Instant now) {
  return input.count == 0 ? kNone : toMilliseconds(input.age(now));
}

}  // namespace

Pipeline::Pipeline(const Parameters& parameters, const std::optional<texture::SurfaceModel>& surface)
    : parameters_(parameters),
      bound_(bindParameters(parameters_)),
      indentation_(parameters.sensing.indentation),
      load_cell_(parameters.sensing.load_cell),
      stiffness_(parameters.sensing.stiffness),
      controller_(parameters.control),
      mixing_(parameters.control),
      renderer_(parameters.texture) {
  if (surface) surface_.emplace(*surface, parameters.texture.sample_rate_Hz);
  const StepParameters& ages = parameters_.step;
  indentation_.setMaximumAges(fromSeconds(ages.ir_maximum_age_ms * 1e-3),
                              fromSeconds(ages.finger_maximum_age_ms * 1e-3));
  stiffness_.setMaximumAge(fromSeconds(ages.bridge_maximum_age_ms * 1e-3));
  stretch_deg_ = parameters.control.travel_minimum_deg;
}

const Outputs& Pipeline::step(const Inputs& inputs) {
  outputs_.events.clear();
  takeTime(inputs);
  applyChanges(inputs);
  applyRobotCommands(inputs);
  sense(inputs);
  stepTare(inputs);
  judge(inputs);
  stepSafety(inputs);
  stepControl(inputs);
  stepTexture(inputs);
  stepMotion(inputs);
  writeTelemetry(inputs);
  last_phase_ = inputs.robot.phase;
  return outputs_;
}

void Pipeline::takeTime(const Inputs& inputs) {
  if (!started_) {
    started_ = true;
    last_now_ = second_start_ = inputs.now;
    missed_at_second_start_ = inputs.missed_cycles;
  }
  elapsed_ = inputs.now - last_now_;
  if (elapsed_ < Duration::zero()) {
    report({.kind = EventKind::time_reversed, .value = toSeconds(-elapsed_)});
    elapsed_ = Duration::zero();
    second_start_ = inputs.now;
    missed_at_second_start_ = inputs.missed_cycles;
  }
  step_gap_ = elapsed_ > kLongestGap;
  if (inputs.now - second_start_ >= std::chrono::seconds(1)) {
    second_start_ = inputs.now;
    missed_at_second_start_ = inputs.missed_cycles;
  }
  steps_missed_ = inputs.missed_cycles > missed_at_second_start_ &&
                  static_cast<double>(inputs.missed_cycles - missed_at_second_start_) > kMostMissedPerSecond;
  last_now_ = inputs.now;
  ++steps_;
}

void Pipeline::applyChanges(const Inputs& inputs) {
  for (const ParameterChange& change : inputs.changes) changeParameter(change.index, change.value);
  for (const OperatorCommand& command : inputs.commands) {
    switch (command.action) {
      case OperatorAction::tare: tare_.start(inputs.now); break;
      case OperatorAction::target_by_hand:
        target_by_hand_ = true;
        if (const Parameter* hand = findParameter(bound_, "pipeline.hand_target_N_per_mm")) {
          changeParameter(static_cast<std::uint16_t>(hand - bound_.data()), command.value);
        }
        break;
      case OperatorAction::target_from_robot: target_by_hand_ = false; break;
      case OperatorAction::arm:
      case OperatorAction::stop: break;  // stepSafety's
    }
  }
}

void Pipeline::changeParameter(std::uint16_t index, double value) {
  const bool allowed = index < bound_.size() && bound_[index].info.live && bound_[index].kind != ParameterKind::list &&
                       std::isfinite(value) && value >= bound_[index].info.minimum &&
                       value <= bound_[index].info.maximum;
  report(
      {.kind = allowed ? EventKind::parameter_changed : EventKind::parameter_refused, .index = index, .value = value});
  if (!allowed) return;
  bound_[index].set(value);
  configure();
}

void Pipeline::configure() {
  indentation_.configure(parameters_.sensing.indentation);
  load_cell_.configure(parameters_.sensing.load_cell);
  stiffness_.configure(parameters_.sensing.stiffness);
  controller_.configure(parameters_.control);
  mixing_.configure(parameters_.control);
  renderer_.configure(parameters_.texture);
}

void Pipeline::applyRobotCommands(const Inputs& inputs) {
  if (inputs.robot.phase != last_phase_ && inputs.robot.phase == LinkPhase::waiting) {
    motion_.reset();  // the next robot stands at its own origin
    robot_sets_reference_ = false;
  }
  const auto indexOf = [this](std::string_view id) {
    return static_cast<std::uint16_t>(findParameter(bound_, id) - bound_.data());
  };
  for (const RobotCommand command : inputs.robot.commands) {
    report({.kind = EventKind::robot_command, .value = static_cast<double>(command)});
    switch (command) {
      case RobotCommand::vibration_down:
      case RobotCommand::vibration_up: {
        const std::uint16_t index = indexOf("texture.k_vib");
        const double change = command == RobotCommand::vibration_up ? kVibrationStep : -kVibrationStep;
        changeParameter(index, std::clamp(parameters_.texture.k_vib + change, bound_[index].info.minimum,
                                          bound_[index].info.maximum));
        break;
      }
      case RobotCommand::use_dft321:
        changeParameter(indexOf("texture.method"), static_cast<double>(texture::MethodChoice::dft321));
        break;
      case RobotCommand::use_soc:
        changeParameter(indexOf("texture.method"), static_cast<double>(texture::MethodChoice::soc));
        break;
      case RobotCommand::motor_reference_on: robot_sets_reference_ = true; break;
      case RobotCommand::motor_reference_off:
      case RobotCommand::disconnect: robot_sets_reference_ = false; break;
      case RobotCommand::none:
      case RobotCommand::send_info_and_pause:
      case RobotCommand::resume:
      case RobotCommand::images_on:
      case RobotCommand::images_off: break;  // the link's
    }
  }
}

void Pipeline::sense(const Inputs& inputs) {
  if (inputs.bridge.count != last_bridge_) {
    last_bridge_ = inputs.bridge.count;
    force_N_ = {.value = load_cell_.force_N(inputs.bridge.value.value_mV_per_V),
                .taken = inputs.bridge.taken,
                .count = inputs.bridge.count};
  }
  indent_ = indentation_.step(inputs.now, inputs.ir, inputs.finger, force_N_);
  stiff_ = stiffness_.step(inputs.now, force_N_, indent_);
  rollers_ = inputs.motors.count == 0 ? control::RollerAngles{}
                                      : control::rollerAngles(inputs.motors.value, parameters_.control);
  if (inputs.finger.count != last_finger_) {
    last_finger_ = inputs.finger.count;
    const sensing::FingerDetection& finger = inputs.finger.value;
    if (finger.contact) {
      finger_speed_.observe(finger.x_mm, finger.y_mm, inputs.finger.taken);
    } else {
      finger_speed_.lift();
    }
  }
}

void Pipeline::stepTare(const Inputs& inputs) {
  if (tare_.state() != sensing::TareState::running) return;
  const sensing::TareState state = tare_.step(inputs.now, indent_, force_N_);
  if (state == sensing::TareState::running) return;
  if (state != sensing::TareState::done) {
    report({.kind = EventKind::tare_failed, .value = static_cast<double>(state)});
    return;
  }
  const sensing::TareResult& result = tare_.result();
  auto& kept = parameters_.sensing.indentation.ir_offset_mm;
  double largest = 0.0;
  kept.count = result.sensors;
  for (std::uint32_t i = 0; i < result.sensors; ++i) {
    largest = std::max(largest, std::abs(result.offset_mm[i] - kept[i]));
    kept[i] = result.offset_mm[i];
  }
  indentation_.tare({result.offset_mm.data(), result.sensors});
  load_cell_.tare(result.force_N);
  parameters_.sensing.load_cell.zero_N = load_cell_.zero_N();
  outputs_.tare = {.ir_offset_mm = kept, .force_zero_N = load_cell_.zero_N()};
  report({.kind = EventKind::tare_done, .value = largest});
}

double Pipeline::target(const Inputs& inputs) const {
  if (target_by_hand_) return parameters_.step.hand_target_N_per_mm;
  return inputs.robot.state.count > 0 ? inputs.robot.state.value.stiffness_N_per_mm : kNone;
}

void Pipeline::judge(const Inputs& inputs) {
  using sensing::IndentationReason;
  lacks_ = health_.judge(inputs,
                         {.bridge_valid = std::isfinite(force_N_.value),
                          .indentation_usable = indent_.reason != IndentationReason::too_few_sensors,
                          .needs_robot = !target_by_hand_,
                          .target_known = target_by_hand_ || inputs.robot.phase != LinkPhase::none},
                         parameters_.step);
  outputs_.lacks = lacks_;
}

std::optional<Lack> Pipeline::fault(const Inputs& inputs) const {
  if (step_gap_) return Lack::step_gap;
  if (steps_missed_) return Lack::steps_missed;
  // A robot that is moved, though its stiffness is not followed, is still driven by this finger.
  if (inputs.robot.phase == LinkPhase::lost && last_phase_ != LinkPhase::lost) return Lack::robot_lost;
  if (lacks_.any()) return InputHealth::first(lacks_);
  return std::nullopt;
}

void Pipeline::stepSafety(const Inputs& inputs) {
  const SafetyState before = safety_.state();
  const auto asked = [&](OperatorAction action) {
    return std::any_of(inputs.commands.begin(), inputs.commands.end(),
                       [action](const OperatorCommand& command) { return command.action == action; });
  };
  if (!InputHealth::devicesLive(lacks_)) {
    safety_.apply(SafetyEvent::devices_gone, InputHealth::first(lacks_));
  } else {
    safety_.apply(SafetyEvent::devices_live);
    if (const auto why = fault(inputs)) safety_.apply(SafetyEvent::fault, *why);
    safety_.apply(lacks_.any() ? SafetyEvent::inputs_missing : SafetyEvent::inputs_complete,
                  InputHealth::first(lacks_));
  }
  if (asked(OperatorAction::arm) && !asked(OperatorAction::stop)) {
    if (lacks_.none()) {
      safety_.apply(SafetyEvent::arm);
    } else {
      report({.kind = EventKind::arm_refused, .state = safety_.state(), .lack = InputHealth::first(lacks_)});
    }
  }
  if (asked(OperatorAction::stop)) safety_.apply(SafetyEvent::stop);
  if (safety_.state() == before) return;
  report({.kind = EventKind::state_changed, .state = safety_.state(), .lack = safety_.heldBecause()});
  if (safety_.state() == SafetyState::active) {
    controller_.reset(rollers_.valid ? rollers_.stretch_deg : kNone);
    robot_sets_reference_ = robot_sets_reference_ && inputs.robot.phase == LinkPhase::running;
  }
}

bool Pipeline::rendering(const Inputs& inputs) const {
  return safety_.state() == SafetyState::active && inputs.robot.phase != LinkPhase::paused;
}

void Pipeline::stepControl(const Inputs& inputs) {
  const bool enabled = rendering(inputs);
  const bool robot_sets = enabled && robot_sets_reference_ && inputs.robot.motor_reference.count > 0;
  control_ = controller_.step({.now = inputs.now,
                               .target_N_per_mm = target(inputs),
                               .measured_N_per_mm = stiff_.stiffness_N_per_mm,
                               .measured_sigma_N_per_mm = stiff_.sigma_N_per_mm,
                               .observable = stiff_.observable,
                               .measured_angle_deg = rollers_.stretch_deg,
                               .measured_angle_known = rollers_.valid,
                               .enabled = enabled && !robot_sets});
  if (robot_sets) {
    followRobotReference(inputs.robot.motor_reference.value);
  } else if (enabled) {
    stretch_deg_ = control_.stretch_angle_deg;
  }
  if (control_.target_clamped && !target_was_clamped_) {
    report({.kind = EventKind::target_clamped, .value = control_.reachable_target_N_per_mm});
  }
  target_was_clamped_ = control_.target_clamped;
  outputs_.motors.active = safety_.state() == SafetyState::active || safety_.state() == SafetyState::held;
  mixing_.mix(stretch_deg_, translation_deg_, outputs_.motors);
}

void Pipeline::followRobotReference(const RobotMotorReference& reference) {
  if (!std::isfinite(reference.first_ticks) || !std::isfinite(reference.second_ticks)) return;
  const control::ControlParameters& limits = parameters_.control;
  const double stretch = 0.5 * (reference.first_ticks - reference.second_ticks) / control::kTicksPerDegree;
  const double translation = 0.5 * (reference.first_ticks + reference.second_ticks) / control::kTicksPerDegree;
  const double furthest = limits.rate_limit_deg_per_s * toSeconds(elapsed_);
  const auto approach = [furthest](double from, double to) {
    return from + std::clamp(to - from, -furthest, furthest);
  };
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
  if (surface_ && inputs.robot.phase == LinkPhase::none) {
    const double speed = indent_.touched ? finger_speed_.at(inputs.now) : 0.0;
    texture_ = renderer_.stepVirtual(surface_->step(speed, force_N_.value), share);
  } else {
    texture_ = renderer_.step(inputs.now, inputs.robot.accelerations.view(), share);
  }
  const double duty = rendering(inputs) && std::isfinite(texture_.duty_percent) ? texture_.duty_percent : 0.0;
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    const double used =
        motors.position_duty_known && std::isfinite(shares[i]) ? std::clamp(shares[i], -100.0, 100.0) : 0.0;
    outputs_.motors.vibration_duty_percent[i] = std::clamp(duty, -100.0 - used, 100.0 - used);
  }
}

void Pipeline::stepMotion(const Inputs& inputs) {
  const StepParameters& step = parameters_.step;
  outputs_.touch = motion_.step({.elapsed = elapsed_,
                                 .enabled = rendering(inputs),
                                 .contact = indent_.touched,
                                 .finger_x_mm = inputs.finger.value.x_mm,
                                 .finger_y_mm = inputs.finger.value.y_mm,
                                 .indentation_mm = indent_.available ? indent_.indentation_mm : kNone,
                                 .force_N = force_N_.value,
                                 .absolute = step.absolute_motion,
                                 .scale = step.motion_scale,
                                 .depth_scale = step.motion_depth_scale,
                                 .speed_limit_mm_s = step.motion_speed_limit_mm_s});
}

void Pipeline::writeTelemetry(const Inputs& inputs) {
  TelemetrySample& out = outputs_.telemetry;
  out = {};
  out.now = inputs.now;
  out.step = steps_;
  out.state = safety_.state();
  out.lack = safety_.state() == SafetyState::held ? safety_.heldBecause() : InputHealth::first(lacks_);
  out.link = inputs.robot.phase;
  out.contact = indent_.touched;
  if (indent_.touched) {
    out.finger_x_mm = inputs.finger.value.x_mm;
    out.finger_y_mm = inputs.finger.value.y_mm;
  }
  if (inputs.finger.count > 0) out.finger_area_px = inputs.finger.value.area_px;
  if (indent_.available) {
    out.indentation_mm = indent_.indentation_mm;
    out.indentation_sigma_mm = indent_.sigma_mm;
  }
  out.force_N = force_N_.count > 0 ? force_N_.value : kNone;
  out.stiffness_N_per_mm = stiff_.known ? stiff_.stiffness_N_per_mm : kNone;
  out.stiffness_observable = stiff_.observable;
  out.target_N_per_mm = target(inputs);
  out.reachable_target_N_per_mm = control_.reachable_target_N_per_mm;
  out.target_clamped = control_.target_clamped;
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
  out.touch_x_mm = outputs_.touch.position_mm.x;
  out.touch_y_mm = outputs_.touch.position_mm.y;
  out.touch_z_mm = outputs_.touch.position_mm.z;
  if (inputs.robot.state.count > 0) {
    out.robot_x_mm = inputs.robot.state.value.position_mm.x;
    out.robot_y_mm = inputs.robot.state.value.position_mm.y;
    out.robot_z_mm = inputs.robot.state.value.position_mm.z;
  }
  out.finger_age_ms = ageMs(inputs.finger, inputs.now);
  out.ir_age_ms = ageMs(inputs.ir, inputs.now);
  out.bridge_age_ms = ageMs(inputs.bridge, inputs.now);
  out.motors_age_ms = ageMs(inputs.motors, inputs.now);
  out.robot_age_ms = ageMs(inputs.robot.state, inputs.now);
  out.missed_cycles = static_cast<double>(inputs.missed_cycles);
}

}  // namespace fyd::pipeline
