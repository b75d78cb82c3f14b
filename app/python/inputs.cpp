// All that reaches a step.
#include "core/pipeline/inputs.h"
#include "app/python/described.h"

namespace fyd::python {
namespace {

using pipeline::Inputs;

/// A list of the inputs as a Python tuple, for what is appended to a copy would be lost; it is set as a whole.
template <class Get>
void addList(py::class_<Inputs>& type, const char* name, const char* help, Get get) {
  using List = std::remove_cvref_t<decltype(get(std::declval<Inputs&>()))>;
  using Item = std::remove_cvref_t<decltype(std::declval<List&>().items[0])>;
  type.def_property(
      name,
      [get](Inputs& inputs) {
        const List& list = get(inputs);
        return py::tuple(py::cast(std::vector<Item>(list.begin(), list.end())));
      },
      [get, name](Inputs& inputs, const std::vector<Item>& items) {
        List list;
        for (const Item& item : items)
          if (!list.push(item))
            throw Refusal{std::string(name) + ": " + std::to_string(items.size()) + " items; at most " +
                          std::to_string(List::capacity()) + " fit"};
        get(inputs) = list;
      },
      help);
}

}  // namespace

void addInputs(py::module_& module) {
  py::class_<Inputs> type(module, "Inputs", "All that reaches a step; nothing else does.");
  describe(type);
  type.def(byNames<Inputs>(), "From values by their names; the others keep their defaults. Units: those in `units`.");
  type.def_readwrite("finger", &Inputs::finger, "What the finger detector says [each in its unit]")
      .def_readwrite("ir", &Inputs::ir, "The distance sensors [ADC code]")
      .def_readwrite("bridge", &Inputs::bridge, "The load cell [mV/V]")
      .def_readwrite("motors", &Inputs::motors, "The motors' report [each in its unit]");
  type.def_property(
      "robot_state", [](Inputs & inputs) -> auto& { return inputs.robot.state; },
      [](Inputs& inputs, const Timed<pipeline::RobotState>& state) { inputs.robot.state = state; },
      py::return_value_policy::reference_internal, "The robot's state [each in its unit]");
  type.def_property(
      "motor_reference", [](Inputs & inputs) -> auto& { return inputs.robot.motor_reference; },
      [](Inputs& inputs, const Timed<pipeline::RobotMotorReference>& reference) {
        inputs.robot.motor_reference = reference;
      },
      py::return_value_policy::reference_internal, "Where the robot wants the motors [tick]");
  addList(
      type, "accelerations", "Samples that came since the last step, a tuple of AccelerationSample, set as a whole [g]",
      [](Inputs & inputs) -> auto& { return inputs.robot.accelerations; });
  addList(
      type, "robot_commands",
      "Commands of the robot's operator since the last step, a tuple of RobotCommand, set as a whole [—]",
      [](Inputs & inputs) -> auto& { return inputs.robot.commands; });
  addList(
      type, "commands",
      "Commands of the operator since the last step, a tuple of OperatorCommand, set as a whole [each in its unit]",
      [](Inputs & inputs) -> auto& { return inputs.commands; });
  addList(
      type, "changes",
      "Live parameters changed since the last step, a tuple of ParameterChange, set as a whole [each in its unit]",
      [](Inputs & inputs) -> auto& { return inputs.changes; });
  type.def(
      "copy", [](const Inputs& inputs) { return inputs; }, "The same inputs once more. Units: none.");
}

}  // namespace fyd::python
