#include "core/station/notice.h"

#include <array>

#include "core/sensing/tare.h"

namespace fyd::station {
namespace {

constexpr std::array<std::string_view, 12> kRobotCommands = {"none",
                                                             "vibration down",
                                                             "vibration up",
                                                             "use DFT321",
                                                             "use SoC",
                                                             "send info and pause",
                                                             "resume",
                                                             "images on",
                                                             "images off",
                                                             "disconnect",
                                                             "motor reference on",
                                                             "motor reference off"};

std::string stateSentence(const pipeline::Event& event) {
  using enum pipeline::SafetyState;
  const std::string name{pipeline::toString(event.state)};
  switch (event.state) {
    case held:
      return fmt::format("{}: {}. {} Then re-arm.", name, pipeline::toString(event.lack), pipeline::remedy(event.lack));
    case stopped: return name + " by the operator. Motors are off. Arm to start again.";
    case active: return name + ": rendering.";
    case ready: return name + ": everything needed is there. Arm to start.";
    case connected: return name + ": sensors are live, motors are off.";
    case disconnected: return name + ": the touchpad does not answer.";
  }
  return name;
}

}  // namespace

std::string_view toString(pipeline::RobotCommand command) {
  const auto index = static_cast<std::size_t>(command);
  return index < kRobotCommands.size() ? kRobotCommands[index] : "unknown";
}

std::string describeEvent(const pipeline::Event& event, std::span<const Parameter> parameters) {
  using enum pipeline::EventKind;
  const std::string_view id = event.index < parameters.size() ? parameters[event.index].id : "a parameter";
  switch (event.kind) {
    case state_changed: return stateSentence(event);
    case arm_refused:
      return fmt::format("Not armed: {}. {}", pipeline::toString(event.lack), pipeline::remedy(event.lack));
    case tare_done: return fmt::format("Tare done; the largest offset moved by {:.2f} mm.", event.value);
    case tare_failed:
      return fmt::format("Tare failed: {}. Keep the cloth untouched and try again.",
                         sensing::toString(static_cast<sensing::TareState>(static_cast<int>(event.value))));
    case parameter_changed: {
      const Parameter* parameter = event.index < parameters.size() ? &parameters[event.index] : nullptr;
      if (parameter != nullptr && parameter->kind == ParameterKind::choice) {
        return fmt::format("{} is now {}.", id, parameter->choices[static_cast<std::size_t>(event.value)]);
      }
      return fmt::format("{} is now {:.4g}.", id, event.value);
    }
    case parameter_refused: return fmt::format("{} = {} was refused.", id, event.value);
    case robot_command:
      return fmt::format("The robot's operator asks: {}.", toString(static_cast<pipeline::RobotCommand>(event.value)));
    case target_clamped:
      return fmt::format("The target is out of reach; rendering the nearest, {:.3f} N/mm.", event.value);
    case time_reversed: return fmt::format("The clock went back by {:.3f} s; that step moved nothing.", event.value);
  }
  return {};
}

}  // namespace fyd::station
