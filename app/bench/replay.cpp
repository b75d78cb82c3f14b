// Speed of a replay of a recording through the step, against the bare step on the same inputs in memory.
#include <thread>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/recorded_session.h"
#include "app/bench/parts/table.h"
#include "core/base/profile_text.h"
#include "core/replay/replay.h"

namespace fyd::bench {
namespace {

double replayedSession_s() { return wholeOrQuick(60.0, 5.0); }
constexpr std::size_t kAtOnce = 2000;  // steps; the recorder's ring takes more

/// @return the inputs, for the baseline
Result<std::vector<pipeline::Inputs>> record(const std::string& path) {
  const auto profile = [](const pipeline::Parameters& step) {
    pipeline::Parameters copy = step;
    return formatProfile(bindParameters(copy));
  };
  recording::Recorder recorder({}, {}, {}, {}, {.profile = profile, .link = {}});
  recorder.start();
  std::vector<pipeline::Inputs> inputs;
  Result<void> begun;
  simulateSession(SessionKind::staircase, replayedSession_s(), [&](const recording::StepView& step) {
    recorder.push(step);
    inputs.push_back(step.inputs);
    if (inputs.size() % kAtOnce != 0) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    if (inputs.size() == kAtOnce) begun = recorder.begin({.path = path});
  });
  if (!begun) return tl::unexpected(begun.error());
  if (const auto ended = recorder.end(); !ended) return tl::unexpected(ended.error());
  return inputs;
}

double bareStep_x(const std::vector<pipeline::Inputs>& inputs) {
  pipeline::Pipeline step({});
  const Instant start = Clock::now();
  for (const pipeline::Inputs& in : inputs) (void)step.step(in);
  return replayedSession_s() / toSeconds(Clock::now() - start);
}

std::vector<std::string> row(const std::string& name, const Result<replay::ReplayResult>& result, double baseline_x) {
  if (!result) return {orFailed(name, result.error().text()), kNothing, kNothing, kNothing, kNothing, kNothing};
  return {name,
          number(1e3 / result->speed_x),
          number(result->speed_x),
          number(result->speed_x / baseline_x),
          number(static_cast<double>(result->different)),
          number(result->max_abs_difference)};
}

}  // namespace

Table bench_replay() {
  const TemporaryFolder folder;
  const std::string path = folder.file("session.h5");
  const auto inputs = record(path);
  Table table{.subject = "replay",
              .title = "Replay of a recording",
              .columns = {{"what", Role::method},
                          {"a step of 1 ms", "µs", Role::cost},
                          "times real time",
                          "ratio",
                          {"differ", "steps", Role::error},
                          "largest difference"},
              .rows = {},
              .notes = {fmt::format(
                  "{:g} s of a finger 6 mm deep, on a cloth whose target goes up and down, with one acceleration a "
                  "step; the file is read from the system's cache. With another gain the steps differ, as they should.",
                  replayedSession_s())}};
  const auto recording = inputs ? recording::Recording::open(path) : tl::unexpected(inputs.error());
  if (!recording) {
    table.rows.push_back(row("recording", tl::unexpected(recording.error()), 1.0));
    return table;
  }
  const double bare_x = bareStep_x(*inputs);
  table.rows.push_back(
      {"bare step, inputs in memory (baseline)", number(1e3 / bare_x), number(bare_x), "1", kNothing, kNothing});
  table.rows.push_back(row("replay, compared bit for bit", replay::replay(**recording, {}), bare_x));
  table.rows.push_back(row("what if control.kp = 0.6, open loop",
                           replay::replay(**recording, {.settings = {"control.kp=0.6"}}), bare_x));
  table.rows.push_back(row("the same, closed loop",
                           replay::replay(**recording, {.settings = {"control.kp=0.6"}, .closed_loop = true}), bare_x));
  return table;
}

}  // namespace fyd::bench
