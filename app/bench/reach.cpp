// fyd bench reach: error between finger and tool, from the simulation's true values, with recorded hands.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/page_run.h"
#include "app/bench/parts/table.h"
#include "app/cli/parts/command.h"
#include "app/cli/parts/trace_file.h"
#include "core/sim/trial/reach_trial.h"
#include "core/teleop/prediction/prediction_trial.h"
#include "core/teleop/prediction/predictor_choice.h"

namespace fyd::bench {
namespace {

using sim::ReachRow;

double seconds() { return wholePageOrQuick(60.0, 20.0, 5.0); }
constexpr double kSettled_s = 3.0;  // armed, connected, and the arm where the finger is
constexpr double kHalfWidth_mm = 32.0, kHalfDepth_mm = 22.0;
constexpr double kShallow_mm = 1.0, kDeep_mm = 6.0;
constexpr int kMostLag = 400;  // ms

struct Hand {
  std::string name;
  sim::FingerPath path;
};

/// A hand's path in the air as that of a finger that stays on the cloth: centred and scaled into the robot's workspace,
/// its heights as 1 to 6 mm of indentation. While the hand was not seen, the finger stays where it was.
sim::FingerPath onTheCloth(const teleop::Trace& trace) {
  teleop::Position low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t row = 0; row < trace.time_s.size(); ++row) {
    if (trace.gap(row)) continue;
    for (std::size_t a = 0; a < trace.axes; ++a) {
      low[a] = std::min(low[a], trace.position_mm[row][a]);
      high[a] = std::max(high[a], trace.position_mm[row][a]);
    }
  }
  const double scale = std::min(2.0 * kHalfWidth_mm / (high[0] - low[0]), 2.0 * kHalfDepth_mm / (high[1] - low[1]));
  std::vector<sim::FingerPath::Knot> knots;
  sim::FingerState state{.x_mm = 0.0, .y_mm = 0.0, .indentation_mm = kShallow_mm, .lifted = false};
  for (std::size_t row = 0; row < trace.time_s.size(); ++row) {
    if (!trace.gap(row)) {
      const teleop::Position& p = trace.position_mm[row];
      state.x_mm = scale * (p[0] - 0.5 * (low[0] + high[0]));
      state.y_mm = scale * (p[1] - 0.5 * (low[1] + high[1]));
      state.indentation_mm = kShallow_mm + (kDeep_mm - kShallow_mm) * (high[2] - p[2]) / (high[2] - low[2]);
    }
    knots.push_back({trace.time_s[row] - trace.time_s.front(), state});
  }
  return sim::FingerPath::fromKnots(std::move(knots));
}

std::vector<Hand> hands() {
  const BenchOptions& options = benchOptions();
  const std::filesystem::path folder =
      std::filesystem::path(options.data.empty() ? "tests/data" : options.data) / "hand_motion";
  std::vector<std::filesystem::path> files;
  std::error_code none;
  for (const auto& each : std::filesystem::directory_iterator(folder, none)) {
    if (each.path().extension() == ".csv") files.push_back(each.path());
  }
  if (files.empty()) throw cli::Failure(say("{}: no CSV files; expected recorded hands", folder.string()));
  std::ranges::sort(files);
  std::vector<Hand> out;
  for (const auto& file : files) {
    const teleop::Trace trace = cli::readTrace(file, {"x_mm", "y_mm", "z_mm"}).trace;
    out.push_back({.name = file.stem(), .path = onTheCloth(trace)});
  }
  return out;
}

/// Lag of the tool's path behind the finger's, ms: at the highest cross-correlation.
double lag_ms(const std::vector<ReachRow>& rows, std::initializer_list<double Vec3::*> axes) {
  const auto begin = static_cast<int>(kSettled_s * 1e3);
  const auto end = static_cast<int>(rows.size());
  const auto at = [&](int i) -> const ReachRow& { return rows[static_cast<std::size_t>(i)]; };
  double best = -1.0;
  int lag = 0;
  for (int shift = -100; shift <= kMostLag; ++shift) {
    const int from = std::max(begin, begin - shift), to = std::min(end, end - shift);
    double product = 0.0, fingers = 0.0, tools = 0.0;
    for (const auto axis : axes) {
      double finger_mean = 0.0, tool_mean = 0.0;
      for (int i = from; i < to; ++i) {
        finger_mean += at(i).finger_mm.*axis;
        tool_mean += at(i + shift).tool_mm.*axis;
      }
      finger_mean /= to - from;
      tool_mean /= to - from;
      for (int i = from; i < to; ++i) {
        const double f = at(i).finger_mm.*axis - finger_mean, t = at(i + shift).tool_mm.*axis - tool_mean;
        product += f * t;
        fingers += f * f;
        tools += t * t;
      }
    }
    const double correlation = product / std::sqrt(fingers * tools);
    if (correlation > best) {
      best = correlation;
      lag = shift;
    }
  }
  return lag;
}

/// The largest n-th difference between ticks, divided by the limit.
double over(const std::vector<ReachRow>& rows, int order, double limit) {
  double largest = 0.0;
  for (std::size_t i = static_cast<std::size_t>(kSettled_s * 1e3); i < rows.size(); ++i) {
    const auto p = [&](std::size_t back) { return rows[i - back].told_mm; };
    const Vec3 d = order == 1   ? p(0) - p(1)
                   : order == 2 ? p(0) - 2.0 * p(1) + p(2)
                                : p(0) - 3.0 * p(1) + 3.0 * p(2) - p(3);
    largest = std::max(largest, std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z) * std::pow(1e3, order));
  }
  return largest / limit;
}

/// Errors in the plane of the cloth.
teleop::TrialFigures figuresOf(const std::vector<ReachRow>& rows) {
  teleop::Trace truth{.axes = 2, .time_s = {}, .position_mm = {}};
  teleop::TrialPlan plan;
  std::vector<teleop::Position> tool;
  for (auto i = static_cast<std::size_t>(kSettled_s * 1e3); i < rows.size(); ++i) {
    plan.ticks.push_back({.row = tool.size(), .begins = tool.empty()});
    truth.time_s.push_back(rows[i].t_s);
    truth.position_mm.push_back({rows[i].finger_mm.x, rows[i].finger_mm.y});
    tool.push_back({rows[i].tool_mm.x, rows[i].tool_mm.y});
  }
  return teleop::trialFigures(truth, plan, tool);
}

std::vector<std::pair<double, std::string>> cases() {
  std::vector<std::pair<double, std::string>> out;
  for (const double delay_ms : {0.0, 50.0}) {
    out.emplace_back(delay_ms, "thesis");
    for (const std::string_view name : teleop::kPredictorNames) out.emplace_back(delay_ms, name);
  }
  return out;
}

double depthRms(const std::vector<ReachRow>& rows) {
  double squares = 0.0;
  int count = 0;
  for (auto i = static_cast<std::size_t>(kSettled_s * 1e3); i < rows.size(); ++i, ++count) {
    const double apart = rows[i].tool_mm.z - rows[i].finger_mm.z;
    squares += apart * apart;
  }
  return std::sqrt(squares / count);
}

}  // namespace

Table bench_reach() {
  Table table;
  table.subject = "reach";
  table.title = "From the finger to the tool";
  table.columns = {{"hand", Role::group},
                   {"protocol", Role::group},
                   {"one way", "ms", Role::group},
                   {"following", Role::method},
                   {"lag", "ms", Role::cost},
                   {"RMS", "mm", Role::error},
                   {"depth's lag", "ms"},
                   {"depth's RMS", "mm"},
                   "vibration ratio",
                   {"largest step", "mm"},
                   "speed / limit",
                   "acceleration / limit",
                   "jerk / limit"};
  for (const Hand& hand : wholeOrFirst(hands(), 1)) {
    for (const bool secured : {true, false}) {
      for (const auto& [delay_ms, following] : cases()) {
        sim::ReachSettings settings;
        settings.touchpad.finger = hand.path;
        settings.touchpad.parameters.step.absolute_motion = true;
        settings.touchpad.sim.material = sim::Material::none;
        settings.network.forward.delay_ms = settings.network.backward.delay_ms = delay_ms;
        settings.reference.predictor = cli::valueOrFail(device::followingNamed(following));
        settings.secured = secured;
        settings.seconds = seconds();
        const auto rows = cli::valueOrFail(sim::reach(settings));
        const teleop::TrialFigures figures = figuresOf(rows);
        table.rows.push_back({hand.name, secured ? "FYD Link" : "classic", number(delay_ms),
                              following == "thesis" ? "thesis (baseline)" : following,
                              number(lag_ms(rows, {&Vec3::x, &Vec3::y})), number(figures.rms_mm),
                              number(lag_ms(rows, {&Vec3::z})), number(depthRms(rows)), number(figures.vibration_ratio),
                              number(figures.largest_step_mm), number(over(rows, 1, settings.limits.speed_mm_s)),
                              number(over(rows, 2, settings.limits.acceleration_mm_s2)),
                              number(over(rows, 3, settings.limits.jerk_mm_s3))});
      }
    }
  }
  table.notes = {
      "Simulated touchpad, both ends of the protocol, the robot end's own way to a simulated arm (60 rad/s, critically "
      "damped), in virtual time; 30 pictures a second. The hand's way in the air is scaled onto the cloth; the truth "
      "is the simulation's finger. Lag: highest cross-correlation, along the cloth; RMS: of the distance along the "
      "cloth; depth by the mapping's scale of 3.",
      "Vibration: 20–200 Hz RMS of the tool's velocity over the finger's, which is recorded at 100 Hz and straight "
      "between rows. Limits: what the arm is told, in differences from tick to tick.",
      "thesis: today's way before prediction, a share of the old target kept at each touch."};
  return table;
}

}  // namespace fyd::bench
