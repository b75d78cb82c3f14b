// The values that go into the step and come out of it, and the numbers that stand for words.
#include "app/python/described.h"
#include "app/python/parameters.h"
#include "core/pipeline/inputs.h"
#include "core/pipeline/outputs.h"
#include "core/recording/recording_types.h"

namespace fyd::python {
namespace {

using namespace pipeline;

/// An enum whose values equal their numbers, as files and columns hold these: `telemetry["state"] ==
/// fyd.SafetyState.active` selects rows. pybind11's own comparison says of every number that it is another.
template <class T>
py::enum_<T> numbered(py::module_& module, const char* name, const char* help) {
  auto type = enumOf<T>(module, name, help);
  // What is neither of this type nor an integer has its own word, as an array has, which answers for each element.
  const auto compared = [](int operation) {
    return [operation](const py::object& self, const py::object& other) {
      const bool integer =
          PyLong_Check(other.ptr()) || py::isinstance(other, py::module_::import("numpy").attr("integer"));
      if (!integer && !py::isinstance<T>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
      return py::reinterpret_steal<py::object>(
          PyObject_RichCompare(py::int_(self).ptr(), py::int_(other).ptr(), operation));
    };
  };
  type.attr("__eq__") = py::cpp_function(compared(Py_EQ), py::name("__eq__"), py::is_method(type), py::arg("other"));
  type.attr("__ne__") = py::cpp_function(compared(Py_NE), py::name("__ne__"), py::is_method(type), py::arg("other"));
  return type;
}

void addEnums(py::module_& module) {
  numbered<SafetyState>(module, "SafetyState", "State of a session; files store the number.")
      .value("disconnected", SafetyState::disconnected)
      .value("connected", SafetyState::connected)
      .value("ready", SafetyState::ready)
      .value("active", SafetyState::active)
      .value("held", SafetyState::held)
      .value("stopped", SafetyState::stopped);
  numbered<LinkPhase>(module, "LinkPhase", "How the robot's link stands; files store the number.")
      .value("none", LinkPhase::none)
      .value("waiting", LinkPhase::waiting)
      .value("running", LinkPhase::running)
      .value("paused", LinkPhase::paused)
      .value("closed", LinkPhase::closed)
      .value("lost", LinkPhase::lost);
  numbered<OperatorAction>(module, "OperatorAction", "What an operator asks for; files store the number.")
      .value("arm", OperatorAction::arm)
      .value("stop", OperatorAction::stop)
      .value("tare", OperatorAction::tare)
      .value("target_by_hand", OperatorAction::target_by_hand)
      .value("target_from_robot", OperatorAction::target_from_robot)
      .value("fell_silent", OperatorAction::fell_silent);
  numbered<RobotCommand>(module, "RobotCommand", "What the robot's operator asks for; files store the number.")
      .value("none", RobotCommand::none)
      .value("vibration_down", RobotCommand::vibration_down)
      .value("vibration_up", RobotCommand::vibration_up)
      .value("use_dft321", RobotCommand::use_dft321)
      .value("use_soc", RobotCommand::use_soc)
      .value("send_info_and_pause", RobotCommand::send_info_and_pause)
      .value("resume", RobotCommand::resume)
      .value("images_on", RobotCommand::images_on)
      .value("images_off", RobotCommand::images_off)
      .value("disconnect", RobotCommand::disconnect)
      .value("motor_reference_on", RobotCommand::motor_reference_on)
      .value("motor_reference_off", RobotCommand::motor_reference_off);
  using sensing::FingerReason;
  numbered<FingerReason>(module, "FingerReason", "Why there is a finger in a picture, or none; files store the number.")
      .value("found", FingerReason::found)
      .value("no_finger", FingerReason::no_finger)
      .value("too_small", FingerReason::too_small)
      .value("at_edge", FingerReason::at_edge)
      .value("several", FingerReason::several)
      .value("flat_picture", FingerReason::flat_picture)
      .value("black_picture", FingerReason::black_picture)
      .value("saturated", FingerReason::saturated)
      .value("blurred", FingerReason::blurred)
      .value("no_picture", FingerReason::no_picture)
      .value("light_unknown", FingerReason::light_unknown);
  using recording::NoteKind;
  numbered<NoteKind>(module, "NoteKind", "What a line of a recording's log is; files store the number.")
      .value("note", NoteKind::note)
      .value("bookmark", NoteKind::bookmark)
      .value("trial_start", NoteKind::trial_start)
      .value("trial_end", NoteKind::trial_end)
      .value("alarm", NoteKind::alarm);
  auto fault = numbered<Fault>(module, "Fault", "What is missing or went wrong; files store the number.");
  fault.value("none", Fault::none);
#define FAULT(name, ...) fault.value(#name, Fault::name);
#include "core/pipeline/fault_list.h"
#undef FAULT
  auto event = numbered<EventKind>(module, "EventKind", "What a step reports; files store the number.");
#define EVENT(name, ...) event.value(#name, EventKind::name);
#include "core/pipeline/event_list.h"
#undef EVENT
}

template <class T>
py::class_<T> addDescribed(py::module_& module, const char* name, const char* help) {
  py::class_<T> type(module, name, help);
  describe(type);
  copyable(type);
  type.def(byNames<T>(), "From values by their names; the others keep their defaults. Units: those in `units`.");
  return type;
}

/// An input with its time: `count` is 0 until the first value.
template <class T>
void addTimed(py::module_& module, const char* name, const char* help) {
  py::class_<Timed<T>> type(module, name, help);
  describe(type);
  copyable(type);
  type.def(byNames<Timed<T>>(), "From values by their names; the others keep their defaults. Units: those in `units`.");
  type.def(
      "set",
      [](Timed<T>& input, std::int64_t taken_ns, const py::kwargs& values) {
        T value = input.value;  // all of it or nothing
        assignNamed(value, values);
        input.value = value;
        input.taken = Instant(Duration(taken_ns));
        ++input.count;
      },
      py::arg("taken_ns"), "A new value, taken at taken_ns [ns]: those named are changed. Units: those in `units`.");
}

}  // namespace

void addValues(py::module_& module) {
  addEnums(module);
  addDescribed<sensing::FingerDetection>(module, "FingerDetection", "What the finger detector says of a picture.");
  addDescribed<control::MotorCommand>(module, "MotorCommand", "What is written to the two motors.");
  addDescribed<TelemetrySample>(module, "TelemetrySample", "One sample of each step; NaN: no value.");
  addDescribed<Event>(module, "Event", "What a step reports.").def_property_readonly("id", &idOfEvent, kIdOfEvent);
  addDescribed<OperatorCommand>(module, "OperatorCommand", "A command of the operator.");
  addDescribed<ParameterChange>(module, "ParameterChange", "A live parameter's new value.")
      .def_property_readonly(
          "id", [](const ParameterChange& change) { return idAt(change.index); },
          "Id of the parameter; None: this library has no such parameter [—]");
  addDescribed<texture::AccelerationSample>(module, "AccelerationSample", "A sample of the robot's accelerometer.");
  addTimed<sensing::FingerDetection>(module, "FingerInput", "The newest picture's result, with its time.");
  addTimed<sensing::IrCounts>(module, "IrInput", "The newest codes of the distance sensors, with their time.");
  addTimed<sensing::BridgeReading>(module, "BridgeInput", "The load cell's newest reading, with its time.");
  addTimed<control::MotorFeedback>(module, "MotorInput", "What the motors last reported, with its time.");
  addTimed<RobotState>(module, "RobotInput", "What the robot last said of itself, with its time.");
  addTimed<RobotMotorReference>(module, "ReferenceInput", "Where the robot wants the motors, with its time.");
}

}  // namespace fyd::python
