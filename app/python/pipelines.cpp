// The pure step.
#include <fmt/format.h>

#include "app/python/described.h"
#include "app/python/parameters.h"
#include "app/python/recordings.h"
#include "app/python/scenes.h"
#include "core/control/stiffness_controller.h"
#include "core/pipeline/pipeline.h"
#include "core/recording/reader/recorded_profile.h"

namespace fyd::python {
namespace {

using pipeline::Inputs;
using pipeline::Outputs;
using StepOwner = Shared<pipeline::Pipeline>;

/// As it stood before the first row of a recording.
std::unique_ptr<StepOwner> recordedPipeline(OpenRecording& file) {
  const auto header = file.info().header;
  const pipeline::Parameters values = done(recording::recordedParameters(header));
  valid(control::checkControlParameters(values.control));
  auto out = std::make_unique<StepOwner>(values, done(recording::recordedLocalModel(header)));
  const std::string state = done(recording::recordedState(header));
  done(out->run([&](pipeline::Pipeline& pipeline) {
    pipeline.takeRecordedValues();
    return pipeline.restoreState(state);
  }));
  return out;
}

void addOutputs(py::module_& module) {
  py::class_<Outputs>(module, "Outputs", "What came of a step.")
      .def_readonly("motors", &Outputs::motors, "What is written to the motors [each in its unit]")
      .def_readonly("telemetry", &Outputs::telemetry, "The step's sample [each in its unit]")
      .def_property_readonly(
          "touch_mm",
          [](const Outputs& out) {
            const Vec3& at = out.touch.position_mm;
            return py::make_tuple(at.x, at.y, at.z);
          },
          "The position sent to the robot: x right, y back, z up [mm]")
      .def_property_readonly(
          "touch_force_N", [](const Outputs& out) { return out.touch.force_N; }, "The force sent to the robot [N]")
      .def_property_readonly(
          "in_contact", [](const Outputs& out) { return out.touch.in_contact; }, "Whether a finger touches [—]")
      .def_property_readonly(
          "faults",
          [](const Outputs& out) {
            std::vector<pipeline::Fault> faults;
            for (const auto& info : pipeline::faultsByUrgency())
              if (out.faults.test(static_cast<std::size_t>(info.fault))) faults.push_back(info.fault);
            return faults;
          },
          "All that is missing for Active, the most urgent first [—]")
      .def_property_readonly(
          "events",
          [](const Outputs& out) { return std::vector<pipeline::Event>(out.events.begin(), out.events.end()); },
          "What the step reports [each in its unit]")
      .def(
          "copy", [](const Outputs& out) { return out; }, "The same outputs once more. Units: none.");
}

}  // namespace

void addPipeline(py::module_& module) {
  addOutputs(module);
  module.def(
      "fault_text",
      [](pipeline::Fault fault) { return py::make_tuple(std::string(toString(fault)), std::string(remedy(fault))); },
      py::arg("fault"), "What is wrong, and what is done about it. Units: none.");

  py::class_<StepOwner>(module, "Pipeline",
                        "The pure step: all haptic behaviour in one function without I/O, threads or clock. The same "
                        "parameters and inputs give the same outputs bit for bit.")
      .def(
          py::init([](const ParameterSet* parameters, const texture::SurfaceModel* surface, const FeltScene* scene) {
            pipeline::LocalModel local;
            if (surface != nullptr) local.surface = checkedSurface(*surface);
            const pipeline::Parameters values = orDefaults(parameters);
            valid(control::checkControlParameters(values.control));
            if (scene != nullptr) {
              local.scene = scene->start();
              const double steps_Hz = values.texture.sample_rate_Hz, scene_Hz = local.scene->rate_Hz();
              if (scene_Hz != steps_Hz)
                throw Refusal{
                    fmt::format("scene: opened for {} Hz; expected {} Hz, texture.sample_rate_Hz", scene_Hz, steps_Hz)};
            }
            return std::make_unique<StepOwner>(values, local);
          }),
          py::arg("parameters") = py::none(), py::arg("surface") = py::none(), py::arg("scene") = py::none(),
          "With these parameters, and what is felt without a robot: a stored surface, or a scene in the robot's place, "
          "opened for the rate of the steps, texture.sample_rate_Hz. Units: each parameter's own.")
      .def(
          "step",
          [](StepOwner& owner, const Inputs& inputs, const std::optional<py::bytes>& state) {
            std::optional<std::string> from;
            if (state) from = std::string(*state);
            const Inputs taken = inputs;  // another thread may change them meanwhile
            return done(owner.run([&](pipeline::Pipeline& pipeline) -> Result<Outputs> {
              if (from)
                if (auto restored = pipeline.restoreState(*from); !restored) return tl::unexpected(restored.error());
              return pipeline.step(taken);
            }));
          },
          py::arg("inputs"), py::arg("state") = py::none(),
          "One step, nominally every millisecond of inputs.now_ns [ns]; from a saved state, when one is given, instead "
          "of "
          "from where it stands. Units: those of the values.")
      .def(
          "save_state",
          [](StepOwner& owner) {
            return py::bytes(owner.run([](pipeline::Pipeline& pipeline) { return pipeline.saveState(); }));
          },
          "All that the next steps depend on, as bytes. Units: none.")
      .def(
          "restore_state",
          [](StepOwner& owner, const py::bytes& state) {
            const std::string bytes = state;
            done(owner.run([&](pipeline::Pipeline& pipeline) { return pipeline.restoreState(bytes); }));
          },
          py::arg("state"),
          "Continues from a saved step of a pipeline with the same parameters, live ones apart; Error, and the "
          "pipeline "
          "as it was, for other bytes. Units: none.")
      .def_static("of", &recordedPipeline, py::arg("recording"),
                  "As it stood before the first row of an open recording: its parameters, its surface or scene and its "
                  "state. Units: each parameter's own.")
      .def_property_readonly(
          "parameters",
          [](StepOwner& owner) {
            return std::make_unique<ParameterSet>(
                owner.run([](pipeline::Pipeline& pipeline) { return pipeline.parameters(); }));
          },
          "As they are now, live changes and tare included: a copy [each in its unit]");
}

}  // namespace fyd::python
