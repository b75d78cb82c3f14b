// One pipeline step: its time, its allocations, and the errors of its results, against the thesis' modes in the same
// run.
#include <cmath>

#include "app/bench/parts/allocation_count.h"
#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/table.h"
#include "core/sim/touchpad/lockstep.h"

namespace fyd::bench {
namespace {

double steppedSession_s() { return wholeOrQuick(16.0, 6.0); }
constexpr double kSettle_s = 1.0;

pipeline::Parameters thesisModes() {
  pipeline::Parameters parameters;
  parameters.sensing.finger.mode = sensing::FingerMode::thesis;
  parameters.sensing.indentation.mode = sensing::IndentationMode::thesis;
  parameters.sensing.stiffness.mode = sensing::StiffnessMode::thesis;
  parameters.control.mode = control::ControlMode::thesis;
  parameters.control.law = control::StaticLawKind::thesis;
  parameters.texture.filter = texture::FilterChoice::thesis;
  parameters.texture.method = texture::MethodChoice::soc;
  parameters.texture.pwm = texture::PwmChoice::thesis;
  parameters.step.absolute_motion = true;
  return parameters;
}

struct Rms {
  double squares = 0.0;
  int count = 0;
  void add(double error) {
    if (!std::isfinite(error)) return;
    squares += error * error;
    ++count;
  }
  [[nodiscard]] double value() const { return count == 0 ? std::nan("") : std::sqrt(squares / count); }
};

struct Run {
  Quantiles time_ns;
  double allocations_per_step = 0.0;
  Rms indentation_mm;
  Rms stiffness_percent;  // the cloth's true stiffness against the target, while pressed
};

/// A session is simulated once to collect its inputs; the step alone is then timed on them.
Run measure(const pipeline::Parameters& parameters) {
  sim::LockstepOptions options;
  options.parameters = parameters;
  options.finger = sim::FingerPath::demonstration();
  sim::Lockstep session(options);
  std::vector<pipeline::Inputs> inputs;
  inputs.reserve(static_cast<std::size_t>(steppedSession_s() * 1000));
  session.spoil = [&inputs](pipeline::Inputs& in) {
    const double phase = 0.7 * static_cast<double>(inputs.size());
    (void)in.robot.accelerations.push(
        {.taken = in.now, .acceleration_g = {std::sin(phase), 0.5 * std::cos(1.3 * phase), 0.2}});
    inputs.push_back(in);
  };
  Run run;
  session.run(0.3);
  (void)session.next.commands.push({.action = pipeline::OperatorAction::arm});
  session.run(steppedSession_s() - 0.3, [&](const pipeline::Outputs& outputs) {
    const sim::WorldSnapshot truth = session.world().truth();
    if (session.time_s() < kSettle_s || !outputs.telemetry.contact || truth.finger.lifted) return;
    run.indentation_mm.add(outputs.telemetry.indentation_mm - truth.finger.indentation_mm);
    run.stiffness_percent.add(100.0 * (truth.stiffness_N_per_mm / outputs.telemetry.target_N_per_mm - 1.0));
  });

  pipeline::Pipeline again(parameters);
  std::size_t next = 0;
  const int steps = static_cast<int>(inputs.size());
  auto times = timeEach(steps, [&] { (void)again.step(inputs[next++]); });
  run.time_ns = quantiles(times);
  pipeline::Pipeline counted(parameters);
  const AllocationCount allocations;
  for (const pipeline::Inputs& in : inputs) (void)counted.step(in);
  run.allocations_per_step = static_cast<double>(allocations.count()) / steps;
  return run;
}

std::vector<std::string> row(const std::string& name, const Run& run, const Run& baseline) {
  return {name,
          number(run.time_ns.p50),
          number(run.time_ns.p99),
          number(run.time_ns.p999),
          number(run.time_ns.p50 / baseline.time_ns.p50),
          number(run.allocations_per_step),
          number(run.indentation_mm.value()),
          number(run.stiffness_percent.value())};
}

}  // namespace

Table bench_step() {
  const Run thesis = measure(thesisModes());
  const Run normal = measure({});
  return {
      .subject = "step",
      .title = "One pipeline step",
      .columns = {{"modes", Role::method},
                  {"p50", "ns", Role::cost},
                  {"p99", "ns"},
                  {"p99.9", "ns"},
                  "p50 ratio",
                  "allocations per step",
                  {"indentation error RMS", "mm", Role::error},
                  {"stiffness error RMS", "%"}},
      .rows = {row("thesis (baseline)", thesis, thesis), row("default", normal, thesis)},
      .notes = {fmt::format(
          "The demonstration gesture, {:g} s, one acceleration per step; inputs are collected from the simulated "
          "touchpad first and the step alone is timed on them. Most steps bring an acceleration and nothing else: the "
          "p50 is of such a step, the p99 of one with a picture's finger, distances or a bridge value. Errors are "
          "against the simulation's truth while the "
          "cloth is touched, the stiffness error between the cloth's true stiffness and the target.",
          steppedSession_s())}};
}

}  // namespace fyd::bench
