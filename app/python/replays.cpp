// Replay and what-if.
#include <fmt/format.h>

#include "app/python/described.h"
#include "app/python/parameters.h"
#include "app/python/recordings.h"
#include "core/control/stiffness_controller.h"
#include "core/recording/reader/recorded_profile.h"
#include "core/replay/replay.h"

namespace fyd::python {
namespace {

using pipeline::TelemetrySample;
using replay::ReplayResult;

struct Replayed {
  ReplayResult result;
  py::dict telemetry;  // column -> array; empty: not kept
};

Replayed replayed(OpenRecording& file, const py::dict& settings, bool closed_loop, bool keep_telemetry) {
  replay::ReplayOptions options{.settings = {}, .closed_loop = closed_loop};
  if (!settings.empty()) {
    const ParameterSet trial(done(recording::recordedParameters(file.info().header)));
    for (const auto& [id, value] : settings) {
      const Parameter& parameter = trial.find(idOf(id));
      const std::string text = written(parameter, value);
      valid(assignParameter(parameter, text, Ranges::mark));
      options.settings.push_back(fmt::format("{}={}", parameter.id, text));
    }
    valid(control::checkControlParameters(trial.values().control));
  }
  std::vector<TelemetrySample> kept;
  ReplayResult result = file.run([&](recording::Recording& recording) {
    return replay::replay(recording, options, [&](const TelemetrySample& sample, const TelemetrySample&) {
      if (keep_telemetry) kept.push_back(sample);
    });
  });
  return {std::move(result), keep_telemetry ? columnsOf(std::move(kept)) : py::dict()};
}

template <class Member>
auto of(Member member) {
  return [member](const Replayed& replayed) { return replayed.result.*member; };
}

}  // namespace

void addReplay(py::module_& module) {
  using R = ReplayResult;
  py::class_<Replayed>(module, "ReplayResult", "What came of running a recording through the step again.")
      .def_readonly(
          "telemetry", &Replayed::telemetry,
          "Every column of the replayed steps by name: views of the steps' own memory, which no copy was made "
          "of [each in its unit]")
      .def_property_readonly("what_if", of(&R::what_if), "Whether parameters were changed [—]")
      .def_property_readonly("closed_loop", of(&R::closed_loop), "Whether motors and load cell answered [—]")
      .def_property_readonly("from_rest", of(&R::from_rest), "Started without the recorded state [—]")
      .def_property_readonly("identical", of(&R::identical), "Every step came out the same, bit for bit [—]")
      .def_property_readonly("steps", of(&R::samples), "Steps run [1]")
      .def_property_readonly("of", of(&R::of), "Steps there were, those included that the recording lost [1]")
      .def_property_readonly("gaps", of(&R::gaps), "Steps the recording lost; the replay ends at the first gap [1]")
      .def_property_readonly(
          "why_not_exact", [](const Replayed& r) { return textOf(r.result.why_not_exact.text()); },
          "What is lost in the recording, so that nothing can be proven; empty: nothing [—]")
      .def_property_readonly("different", of(&R::different), "Steps that differ [1]")
      .def_property_readonly("out_of_range", of(&R::out_of_range), "Parameters with a value beyond today's range [—]")
      .def_property_readonly("unknown_changes", of(&R::unknown_changes),
                             "Recorded changes of parameters that this library does not know [1]")
      .def_property_readonly("first_difference_s", of(&R::first_difference_s),
                             "Time of the first step that differs; NaN: none [s]")
      .def_property_readonly("first_difference_field", of(&R::first_difference_field), "What differs there [—]")
      .def_property_readonly("max_abs_difference", of(&R::max_abs_difference),
                             "Largest difference; infinite: a number against NaN [the column's unit]")
      .def_property_readonly("max_difference_field", of(&R::max_difference_field), "Where that is [—]")
      .def_property_readonly("stiffness_error_recorded_percent", of(&R::stiffness_error_recorded_percent),
                             "RMS of measured against target stiffness while observable, as recorded [%]")
      .def_property_readonly("stiffness_error_replayed_percent", of(&R::stiffness_error_replayed_percent),
                             "The same, as replayed [%]")
      .def_property_readonly("duration_s", of(&R::duration_s), "Of the replayed part [s]")
      .def_property_readonly("speed_x", of(&R::speed_x), "Times real time [1]");

  module.def("replay", &replayed, py::arg("recording"), py::arg("settings") = py::dict(),
             py::arg("closed_loop") = false, py::arg("keep_telemetry") = true,
             "Runs a recording through the step again: unchanged, which proves the outputs bit for bit, or with other "
             "parameters (`settings`, id to value). closed_loop: motors and load cell react to the new commands. "
             "Other threads go on meanwhile. Units: those of the columns, and of each parameter.");
}

}  // namespace fyd::python
