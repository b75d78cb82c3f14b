// fyd bench predict: error against cost of every predictor over recorded motions.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <map>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/cost_picture.h"
#include "app/bench/parts/table.h"
#include "app/cli/parts/command.h"
#include "app/cli/parts/trace_file.h"
#include "core/teleop/prediction/predictor_choice.h"

namespace fyd::bench {
namespace {

using namespace teleop;

struct MotionSet {
  std::string name;
  std::string folder;
  std::string begins;  ///< of the files' names
  double period_ms;
  std::vector<double> delays_ms;
  bool trained = false;  ///< the perceptron of `default` has been trained on these
};

const std::vector<MotionSet>& motionSets() {
  static const std::vector<MotionSet> sets = {
      {"lever (teleop_1dof)", "teleop_1dof", "", 10.0, {10, 30, 50, 100, 200}},
      {"hand in the air (hand_motion)", "hand_motion", "", 10.0, {10, 30, 50, 100, 200}},
      {"pen", "strokes", "pen", 10.0, {10, 30, 50, 100, 200}},
      {"finger: writing", "strokes", "write", 0.0, {33, 67, 100}, true},
      {"finger: drawing", "strokes", "paint", 0.0, {33, 67, 100}, true},
      {"finger: targets", "strokes", "fitts", 0.0, {33, 67, 100}, true}};
  return sets;
}

std::vector<Trace> tracesOf(const MotionSet& set, const std::filesystem::path& data) {
  std::vector<std::filesystem::path> files;
  std::error_code none;
  for (const auto& each : std::filesystem::directory_iterator(data / set.folder, none)) {
    const std::string name = each.path().filename();
    if (name.ends_with(".csv") && name.starts_with(set.begins)) files.push_back(each.path());
  }
  std::ranges::sort(files);
  std::vector<Trace> out;
  out.reserve(files.size());
  for (const auto& file : files) out.push_back(cli::readTrace(file, {}).trace);
  return wholeOrFirst(out, 1);
}

double processor_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

struct Pooled {
  double squares = 0.0, ns = 0.0;
  double ticks = 0.0, axis_ticks = 0.0;
  double worst = 0.0;  ///< RMS by order 0's, of the worst recording
  double max_mm = 0.0;

  [[nodiscard]] double rms() const { return std::sqrt(squares / ticks); }
};

std::map<std::string_view, Pooled> measure(const std::vector<Trace>& traces, double period_ms, double delay_ms) {
  std::map<std::string_view, Pooled> out;
  for (const Trace& trace : traces) {
    const TrialPlan plan = planTrial(trace, {.period_ms = period_ms, .delay_ms = delay_ms});
    if (plan.ticks.empty()) continue;
    double order0 = 0.0;
    for (std::size_t choice = 0; choice < kPredictorNames.size(); ++choice) {
      const auto predictor =
          makePredictor(static_cast<PredictorChoice>(choice), {.axes = trace.axes, .period_s = 1e-3 * period_ms});
      const double start_ns = processor_ns();
      const std::vector<Position> output = runTrial(trace, plan, *predictor, 0.0);
      const double took_ns = processor_ns() - start_ns;
      const TrialFigures figures = trialFigures(trace, plan, output);
      if (choice == 0) order0 = figures.rms_mm;
      const auto ticks = static_cast<double>(figures.ticks);
      Pooled& pooled = out[kPredictorNames[choice]];
      pooled.squares += figures.rms_mm * figures.rms_mm * ticks;
      pooled.ticks += ticks;
      pooled.ns += took_ns;
      pooled.axis_ticks += ticks * static_cast<double>(trace.axes);
      pooled.worst = std::max(pooled.worst, figures.rms_mm / order0);
      pooled.max_mm = std::max(pooled.max_mm, figures.max_mm);
    }
  }
  return out;
}

}  // namespace

Table bench_predict() {
  const BenchOptions& options = benchOptions();
  const std::filesystem::path data = options.data.empty() ? "tests/data" : options.data;
  Table table;
  table.subject = "predict";
  table.title = "Predictors: error against cost over recorded motions";
  table.columns = {{"motion", Role::group},
                   "recordings",
                   {"delay", "ms", Role::group},
                   {"predictor", Role::method},
                   {"RMS", "mm", Role::error},
                   {"gain over the paper's best", "%"},
                   "worst / order 0",
                   {"max", "mm"},
                   {"a step and axis", "ns", Role::cost}};
  std::vector<CostPanel> panels;
  for (const MotionSet& set : wholeOrFirst(motionSets(), 1)) {
    const std::vector<Trace> traces = tracesOf(set, data);
    if (traces.empty()) {
      table.notes.push_back(fmt::format("{}: no recordings in {}.", set.name, (data / set.folder).string()));
      continue;
    }
    for (const double delay_ms : wholeOrFirst(set.delays_ms, 1)) {
      auto pooled = measure(traces, set.period_ms, delay_ms);
      const auto paper = std::min({"order0", "order1", "hybrid"}, [&](const char* one, const char* other) {
        return pooled[one].rms() < pooled[other].rms();
      });
      const double best = pooled[paper].rms();
      CostPanel panel{.title = fmt::format("{}, {:.0f} ms", set.name, delay_ms), .points = {}};
      for (const std::string_view name : kPredictorNames) {
        const Pooled& each = pooled[name];
        const double ns = each.ns / each.axis_ticks;
        table.rows.push_back({set.name, std::to_string(traces.size()), number(delay_ms),
                              std::string(name) + (name == paper ? " (the paper's best, baseline)" : "") +
                                  (name == "default" && set.trained ? ", on what it was trained on" : ""),
                              number(each.rms()), fmt::format("{:.1f}", 100.0 * (1.0 - each.rms() / best)),
                              number(each.worst), number(each.max_mm), number(ns)});
        panel.points.push_back({std::string(name), ns, each.rms() / best});
      }
      if (delay_ms == 50.0 || delay_ms == 67.0) panels.push_back(std::move(panel));
    }
  }
  table.notes.push_back(
      "Messages each 10 ms (lever, hand, pen) or each row (finger); pooled over recordings; the baseline is the best "
      "of "
      "order0, order1 and hybrid in the same row of delays. Processor time, messages' work included.");
  table.notes.push_back(
      "The perceptron of `default` has been trained on the finger's recordings of people 1 to 4 and the constants of "
      "`default` were chosen on all of these recordings; those of the paper's three were not. "
      "What `default` does on people it was not trained on is in the manual's leave-one-person-out figures.");
  if (table.rows.empty()) throw cli::Failure(say("{}: no recordings in teleop_1dof or hand_motion", data.string()));
  if (!panels.empty()) {
    const CostAxes axes{.errors = {0.0, 0.5, 1.0, 1.5, 2.0}, .marked_error = 1.0, .unit = {}, .marked = "default"};
    writeBeside("predict.svg", errorAgainstCost(panels, axes));
  }
  return table;
}

}  // namespace fyd::bench
