#include "tests/soak/soak_checks.h"

#include <algorithm>
#include <cmath>

namespace fyd::soak {
namespace {

using pipeline::OperatorAction;
using pipeline::SafetyState;

bool asked(const pipeline::Inputs& inputs, OperatorAction action) {
  return std::ranges::any_of(inputs.commands.view(),
                             [action](const auto& command) { return command.action == action; });
}

bool rendering(const pipeline::Inputs& inputs, SafetyState state) {
  return state == SafetyState::active && inputs.robot.phase != pipeline::LinkPhase::paused;
}

void expect(bool holds, const char* what, double value, double limit) {
  if (!holds) broken(fmt::format("{} is {}, expected within {}", what, value, limit));
}

}  // namespace

void Checks::numbers(const pipeline::Outputs& outputs) const {
  for (const double duty : outputs.motors.vibration_duty_percent) {
    expect(std::abs(duty) <= 100.0, "a vibration duty in percent", duty, 100.0);  // no NaN passes
  }
  const double most_ticks = parameters_.control.motor_limit_deg * control::kTicksPerDegree + 1.0;
  for (const std::int16_t ticks : outputs.motors.reference_ticks) {
    expect(std::abs(static_cast<double>(ticks)) <= most_ticks, "a motor's reference in ticks", ticks, most_ticks);
  }
  const Vec3& touch = outputs.touch.position_mm;
  expect(std::abs(touch.x) <= pipeline::kWorkspaceHalf_mm.x, "the touch's x in mm", touch.x, 35.0);
  expect(std::abs(touch.y) <= pipeline::kWorkspaceHalf_mm.y, "the touch's y in mm", touch.y, 25.0);
  expect(std::abs(touch.z) <= pipeline::kWorkspaceHalf_mm.z, "the touch's z in mm", touch.z, 70.0);
  expect(outputs.touch.force_N >= 0.0 && std::isfinite(outputs.touch.force_N), "the touch's force in N",
         outputs.touch.force_N, 0.0);
  const double stretch = outputs.telemetry.stretch_reference_deg;
  // Below its travel only on its way into it, from where a loose cloth left the rollers.
  const double least_deg = std::min(parameters_.control.travel_minimum_deg, std::max(0.0, stretch_deg_));
  const double begins_deg = std::min(least_deg, std::max(0.0, outputs.telemetry.stretch_measured_deg));
  expect(stretch >= begins_deg - 1e-9 && stretch <= parameters_.control.travel_maximum_deg + 1e-9,
         "the stretch in degrees", stretch, parameters_.control.travel_maximum_deg);
  expect(std::isfinite(outputs.telemetry.texture_signal_g), "the texture's signal in g", 0.0, 0.0);
}

void Checks::standstill(const pipeline::Inputs& inputs, const pipeline::Outputs& outputs) const {
  const SafetyState now = outputs.telemetry.state;
  const bool on = now == SafetyState::active || now == SafetyState::held;
  if (outputs.motors.active != on) {
    broken(fmt::format("the motors are {} in the state {}", outputs.motors.active ? "on" : "off", toString(now)));
  }
  const double elapsed_s = toSeconds(inputs.now - before_);
  const double moved_deg = std::abs(outputs.telemetry.stretch_reference_deg - stretch_deg_);
  const double most_deg = parameters_.control.rate_limit_deg_per_s * std::max(0.0, elapsed_s) + 1e-9;
  // Rendering begins where the motors stand, so that they do not jump; else the reference keeps to its rate.
  const double stands_deg =
      std::clamp(outputs.telemetry.stretch_measured_deg, 0.0, parameters_.control.travel_maximum_deg);
  const double from_there_deg = std::abs(outputs.telemetry.stretch_reference_deg - stands_deg);
  expect(moved_deg <= most_deg || from_there_deg <= most_deg, "the stretch's motion in a step in degrees", moved_deg,
         most_deg);
  const double touched_mm = (outputs.touch.position_mm - touch_mm_).norm();
  const double most_mm = parameters_.step.motion_speed_limit_mm_s * std::max(0.0, elapsed_s) * std::sqrt(3.0) + 1e-9;
  expect(touched_mm <= most_mm, "the touch's motion in a step in mm", touched_mm, most_mm);
  if (rendering(inputs, now)) return;
  for (const double duty : outputs.motors.vibration_duty_percent) {
    expect(duty == 0.0, "a vibration duty outside Active", duty, 0.0);
  }
  if (!inputs.changes.empty()) return;  // a live parameter of the mixing moves the ticks of the same stretch
  expect(touched_mm == 0.0, "the touch's motion outside Active in mm", touched_mm, 0.0);
  if (now == SafetyState::active && state_ != now)
    return;  // armed in a pause: the references are where the motors stand
  expect(outputs.motors.reference_ticks == motors_.reference_ticks, "a motor's reference outside Active, in ticks",
         outputs.motors.reference_ticks[0], motors_.reference_ticks[0]);
  expect(moved_deg == 0.0, "the stretch's motion outside Active in degrees", moved_deg, 0.0);
}

void Checks::transition(const pipeline::Inputs& inputs, const pipeline::Outputs& outputs) {
  const SafetyState now = outputs.telemetry.state;
  const bool arms = asked(inputs, OperatorAction::arm);
  const bool stops = asked(inputs, OperatorAction::stop);
  for (const pipeline::Event& event : outputs.events.view()) {
    if (event.kind == pipeline::EventKind::arm_refused) ++figures_.refused_arms;
  }
  if (stops && now != SafetyState::stopped) broken(fmt::format("a stop led to {}", toString(now)));
  if (now == state_) return;
  const auto change = [&] { return fmt::format("{} became {}", toString(state_), toString(now)); };
  if (now == SafetyState::active && !arms) broken(change() + " without an arm");
  // Arm and the window's silence in one step go through Active to Held.
  if (state_ == SafetyState::held && !arms && !stops) broken(change() + " without an operator");
  if (state_ == SafetyState::stopped && !arms) broken(change() + " without an arm");
  if (now == SafetyState::held) {
    if (outputs.telemetry.fault == pipeline::Fault::none) broken(change() + " without a cause");
    ++figures_.held[std::string(toString(outputs.telemetry.fault))];
  }
  if (state_ == SafetyState::active && now != SafetyState::held && now != SafetyState::stopped) broken(change());
  if (now == SafetyState::active) ++figures_.arms;
}

void Checks::look(const pipeline::Inputs& inputs, const pipeline::Outputs& outputs) {
  numbers(outputs);
  if (began_) standstill(inputs, outputs);
  transition(inputs, outputs);
  for (const auto& command : inputs.commands.view()) {
    if (command.action == OperatorAction::target_by_hand) by_hand_ = true;
    if (command.action == OperatorAction::target_from_robot) by_hand_ = false;
  }
  began_ = true;
  before_ = inputs.now;
  state_ = outputs.telemetry.state;
  if (state_ == SafetyState::active) last_active_ = inputs.now;
  motors_ = outputs.motors;
  touch_mm_ = outputs.touch.position_mm;
  stretch_deg_ = outputs.telemetry.stretch_reference_deg;
  ++figures_.steps;
  figures_.active_steps += state_ == SafetyState::active ? 1 : 0;
}

}  // namespace fyd::soak
