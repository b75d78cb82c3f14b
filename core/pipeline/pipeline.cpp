// The step's first half: what comes in (time, changes, sensing, safety). The second half is pipeline_outputs.cpp.
#include "core/pipeline/pipeline.h"

#include <algorithm>
#include <cmath>

#include "core/scene/felt_scene.h"

namespace fyd::pipeline {
namespace {

constexpr Duration kLongestGap = std::chrono::milliseconds(20);
constexpr double kMostMissedPerSecond = 0.05 * 1000.0;
constexpr double kVibrationStep = 0.1;  // of the robot operator's keys [authors' program]

}  // namespace

Pipeline::Pipeline(const Parameters& parameters, const LocalModel& local)
    : parameters_(parameters),
      bound_(bindParameters(parameters_)),
      indentation_(parameters.sensing.indentation),
      load_cell_(parameters.sensing.load_cell),
      stiffness_(parameters.sensing.stiffness),
      controller_(parameters.control),
      mixing_(parameters.control),
      renderer_(parameters.texture),
      finger_prediction_(parameters.texture.plant, parameters.texture.sample_rate_Hz) {
  if (local.surface) surface_.emplace(*local.surface, parameters.texture.sample_rate_Hz);
  if (local.scene) scene_ = std::make_unique<scene::FeltScene>(*local.scene);
  const StepParameters& ages = parameters_.step;
  indentation_.setMaximumAges(fromSeconds(ages.ir_maximum_age_ms * 1e-3),
                              fromSeconds(ages.finger_maximum_age_ms * 1e-3));
  stiffness_.setMaximumAge(fromSeconds(ages.bridge_maximum_age_ms * 1e-3));
  stretch_deg_ = parameters.control.travel_minimum_deg;
}

Pipeline::~Pipeline() = default;

const Outputs& Pipeline::step(const Inputs& inputs) {
  outputs_.events.clear();
  takeTime(inputs);
  applyChanges(inputs);
  applyRobotCommands(inputs);
  sense(inputs);
  stepTare(inputs);
  judge(inputs);
  stepSafety(inputs);
  stepMotion(inputs);
  stepScene(inputs);
  stepCoupling(inputs);
  stepControl(inputs);
  stepTexture(inputs);
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
  last_now_ = inputs.now;
  ++steps_;
}

template <class Value>
bool Pipeline::setParameter(std::string_view id, Value&& value) {
  const Parameter* parameter = findParameter(bound_, id);
  return changeParameter(static_cast<std::uint16_t>(parameter - bound_.data()), value(*parameter));
}

void Pipeline::applyChanges(const Inputs& inputs) {
  for (const ParameterChange& change : inputs.changes) (void)changeParameter(change.index, change.value);
  for (const OperatorCommand& command : inputs.commands) {
    switch (command.action) {
      case OperatorAction::tare: tare_.start(inputs.now); break;
      case OperatorAction::target_by_hand:
        // A refused value leaves the target with whoever has it: an older one by hand would be felt instead.
        if (setParameter(kHandTarget, [&command](const Parameter&) { return command.value; })) target_by_hand_ = true;
        break;
      case OperatorAction::target_from_robot: target_by_hand_ = false; break;
      case OperatorAction::arm:
      case OperatorAction::fell_silent:
      case OperatorAction::stop: break;  // handled in stepSafety
    }
  }
}

bool Pipeline::changeParameter(std::uint16_t index, double value) {
  const bool allowed = index < bound_.size() && bound_[index].info.live && bound_[index].isNumber() &&
                       mayTake(bound_[index], value, ranges_);
  report(
      {.kind = allowed ? EventKind::parameter_changed : EventKind::parameter_refused, .index = index, .value = value});
  if (!allowed) return false;
  bound_[index].set(value);
  configure();
  return true;
}

void Pipeline::configure() {
  indentation_.configure(parameters_.sensing.indentation);
  load_cell_.configure(parameters_.sensing.load_cell);
  stiffness_.configure(parameters_.sensing.stiffness);
  controller_.configure(parameters_.control);
  mixing_.configure(parameters_.control);
  renderer_.configure(parameters_.texture);
}

std::string_view Pipeline::parameterOf(RobotCommand command) {
  switch (command) {
    case RobotCommand::vibration_down:
    case RobotCommand::vibration_up: return "texture.k_vib";
    case RobotCommand::use_dft321:
    case RobotCommand::use_soc: return "texture.method";
    default: return {};
  }
}

void Pipeline::applyRobotCommands(const Inputs& inputs) {
  // The motion is not reset: a robot that reconnects stands where it was left.
  const bool left = inputs.robot.phase == LinkPhase::waiting || inputs.robot.phase == LinkPhase::closed;
  if (inputs.robot.phase != last_phase_ && left) robot_sets_reference_ = false;
  for (const RobotCommand command : inputs.robot.commands) {
    report({.kind = EventKind::robot_command, .value = static_cast<double>(command)});
    switch (command) {
      case RobotCommand::vibration_down:
      case RobotCommand::vibration_up:
        setParameter(parameterOf(command), [command](const Parameter& k_vib) {
          const double change = command == RobotCommand::vibration_up ? kVibrationStep : -kVibrationStep;
          const double now = k_vib.value();  // outside the range only in a replay; then not clamped to it
          return std::clamp(now + change, std::min(now, k_vib.info.minimum), std::max(now, k_vib.info.maximum));
        });
        break;
      case RobotCommand::use_dft321:
        setParameter(parameterOf(command),
                     [](const Parameter&) { return static_cast<double>(texture::MethodChoice::dft321); });
        break;
      case RobotCommand::use_soc:
        setParameter(parameterOf(command),
                     [](const Parameter&) { return static_cast<double>(texture::MethodChoice::soc); });
        break;
      case RobotCommand::motor_reference_on: robot_sets_reference_ = true; break;
      case RobotCommand::motor_reference_off:
      case RobotCommand::disconnect: robot_sets_reference_ = false; break;
      case RobotCommand::none:
      case RobotCommand::send_info_and_pause:
      case RobotCommand::resume:
      case RobotCommand::images_on:
      case RobotCommand::images_off: break;  // handled by the link
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
  contact_ = indentation_.contactOf(inputs.finger.value);
  stiff_ = stiffness_.step(inputs.now, force_N_, indent_);
  rollers_ = inputs.motors.count == 0 ? control::RollerAngles{}
                                      : control::rollerAngles(inputs.motors.value, parameters_.control);
  if (inputs.finger.count != last_finger_) {
    last_finger_ = inputs.finger.count;
    if (inputs.finger.value.contact) {
      finger_speed_.observe(contact_.x_mm, contact_.y_mm, inputs.finger.taken);
    } else {
      finger_speed_.lift();
    }
  }
}

void Pipeline::stepTare(const Inputs& inputs) {
  if (tare_.state() != sensing::TareState::running) return;
  sensing::IndentationEstimate seen = indent_;
  if (!seen.touched && !showsCloth(inputs.finger.value.reason)) seen.reason = sensing::IndentationReason::finger_stale;
  const sensing::TareState state = tare_.step(inputs.now, seen, force_N_);
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

void Pipeline::judge(const Inputs& inputs) {
  using sensing::IndentationReason;
  const Judgement judged = health_.judge(
      inputs,
      {.bridge_valid = std::isfinite(force_N_.value),
       .indentation_usable = indent_.reason != IndentationReason::too_few_sensors,
       .needs_robot = !target_by_hand_ && !scene_,
       .target_known = target_by_hand_ || scene_ || inputs.robot.phase != LinkPhase::none,
       .step_gap = elapsed_ > kLongestGap,
       .steps_missed = inputs.missed_cycles > missed_at_second_start_ &&
                       static_cast<double>(inputs.missed_cycles - missed_at_second_start_) > kMostMissedPerSecond},
      parameters_.step);
  if (inputs.now - second_start_ >= std::chrono::seconds(1)) {  // what was missed up to here is judged with the old one
    second_start_ = inputs.now;
    missed_at_second_start_ = inputs.missed_cycles;
  }
  faults_ = judged.faults;
  interruptions_ = judged.interruptions;
  outputs_.faults = faults_;
}

std::optional<Fault> Pipeline::newFault(const Inputs& inputs) const {
  if (interruptions_.any()) return InputHealth::first(interruptions_);
  // This finger also moves a robot whose stiffness is not followed, so its loss is a fault even then.
  if (inputs.robot.phase == LinkPhase::lost && last_phase_ != LinkPhase::lost) return Fault::robot_lost;
  if (faults_.any()) return InputHealth::first(faults_);
  return std::nullopt;
}

void Pipeline::stepSafety(const Inputs& inputs) {
  const SafetyState before = safety_.state();
  const auto asked = [&](OperatorAction action) {
    return std::any_of(inputs.commands.begin(), inputs.commands.end(),
                       [action](const OperatorCommand& command) { return command.action == action; });
  };
  if (!InputHealth::devicesLive(faults_)) {
    safety_.apply(SafetyEvent::devices_gone, InputHealth::first(faults_));
  } else {
    safety_.apply(SafetyEvent::devices_live);
    if (const auto why = newFault(inputs)) safety_.apply(SafetyEvent::fault, *why);
    safety_.apply(faults_.any() ? SafetyEvent::inputs_missing : SafetyEvent::inputs_complete,
                  InputHealth::first(faults_));
  }
  if (asked(OperatorAction::arm) && !asked(OperatorAction::stop)) {
    if (faults_.none()) {
      safety_.apply(SafetyEvent::arm);
    } else {
      report({.kind = EventKind::arm_refused, .state = safety_.state(), .fault = InputHealth::first(faults_)});
    }
  }
  // After arm: when the window stops answering in the same step, the fault wins.
  if (asked(OperatorAction::fell_silent)) safety_.apply(SafetyEvent::fault, Fault::operator_silent);
  if (asked(OperatorAction::stop)) safety_.apply(SafetyEvent::stop);
  if (safety_.state() == before) return;
  report({.kind = EventKind::state_changed, .state = safety_.state(), .fault = safety_.heldBecause()});
  if (safety_.state() == SafetyState::active) {
    controller_.reset(rollers_.valid ? rollers_.stretch_deg : kNone);
    if (rollers_.valid) {  // whatever was commanded before: the motors were off since, and a loose cloth went to 0
      const control::ControlParameters& p = parameters_.control;
      stretch_deg_ = std::clamp(rollers_.stretch_deg, std::min(0.0, p.travel_minimum_deg), p.travel_maximum_deg);
      translation_deg_ = std::clamp(rollers_.translation_deg, -p.motor_limit_deg, p.motor_limit_deg);
    }
    robot_sets_reference_ = robot_sets_reference_ && inputs.robot.phase == LinkPhase::running;
  }
}

}  // namespace fyd::pipeline
