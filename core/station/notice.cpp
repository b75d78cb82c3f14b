#include "core/station/notice.h"

#include <array>

#include "core/base/message.h"
#include "core/sensing/tare.h"

namespace fyd::station {
namespace {

constexpr std::array<std::string_view, 12> kRobotCommands = {sentence("none"),
                                                             sentence("vibration down"),
                                                             sentence("vibration up"),
                                                             sentence("use DFT321"),
                                                             sentence("use SoC"),
                                                             sentence("send info and pause"),
                                                             sentence("resume"),
                                                             sentence("images on"),
                                                             sentence("images off"),
                                                             sentence("disconnect"),
                                                             sentence("motor reference on"),
                                                             sentence("motor reference off")};

Message heldSentence(const pipeline::Event& event, const Lateness& lateness) {
  const Message name = phrase(toString(event.state));
  if (Message blame = blameOf(event, lateness); !blame.empty()) {
    return say("{}: {}; {}. Then re-arm.", name, phrase(toString(event.fault)), std::move(blame));
  }
  return say("{}: {}. {} Then re-arm.", name, phrase(toString(event.fault)), phrase(remedy(event.fault)));
}

Message stateSentence(const pipeline::Event& event, const Lateness& lateness) {
  using enum pipeline::SafetyState;
  Message name = phrase(toString(event.state));
  switch (event.state) {
    case held: return heldSentence(event, lateness);
    case stopped: return say("{} by the operator. Motors are off. Arm to start again.", name);
    case active: return say("{}: rendering.", name);
    case ready: return say("{}: everything needed is there. Arm to start.", name);
    case connected: return say("{}: sensors are live, motors are off.", name);
    case disconnected: return say("{}: the touchpad does not answer.", name);
  }
  return name;
}

Message whyNoTare(const pipeline::Event& event) {
  return phrase(sensing::toString(static_cast<sensing::TareState>(static_cast<int>(event.value))));
}

Message nameOf(const pipeline::Event& event, std::span<const Parameter> parameters) {
  if (event.index >= parameters.size()) return phrase(sentence("a parameter"));
  return verbatim(std::string(parameters[event.index].id));
}

Message changeSentence(const pipeline::Event& event, std::span<const Parameter> parameters) {
  Message name = nameOf(event, parameters);
  if (event.index < parameters.size() && parameters[event.index].kind == ParameterKind::choice) {
    const std::string_view word = parameters[event.index].choices[static_cast<std::size_t>(event.value)];
    return say("{} is now {}.", std::move(name), std::string(word));
  }
  return say("{} is now {:.4g}.", std::move(name), event.value);
}

}  // namespace

std::string_view toString(pipeline::RobotCommand command) {
  const auto index = static_cast<std::size_t>(command);
  return index < kRobotCommands.size() ? kRobotCommands[index] : sentence("unknown");
}

Message blameOf(const pipeline::Event& event, const Lateness& lateness) {
  const bool held = event.kind == pipeline::EventKind::state_changed && event.state == pipeline::SafetyState::held;
  return held && mayBeLateness(event.fault) ? describe(lateness) : Message{};
}

Message describeEvent(const pipeline::Event& e, std::span<const Parameter> parameters, const Lateness& lateness) {
  using pipeline::EventKind;
  using pipeline::RobotCommand;
  switch (e.kind) {
#define EVENT(name, number, label, severity, slides_in, weight, said, logged) \
  case EventKind::name:                                                       \
    return said;
#include "core/pipeline/event_list.h"
#undef EVENT
  }
  return {};
}

}  // namespace fyd::station
