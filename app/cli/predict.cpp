// fyd predict TRACE.csv --predictor NAME --period MS --delay MS [--jitter MS] [--loss PCT] [--seed I] [--smooth MS]
//             [--columns A,B,C] [--weights FILE] [--out FILE] [--json]
#include <cmath>
#include <ctime>
#include <iostream>

#include "app/cli/parts/command.h"
#include "app/cli/parts/output_file.h"
#include "app/cli/parts/trace_file.h"
#include "core/teleop/prediction/learned_forecast.h"
#include "core/teleop/prediction/predictor_choice.h"

namespace fyd::cli {
namespace {

using namespace teleop;

struct PredictOptions {
  std::string trace;
  std::string predictor = "default";
  TrialNetwork network;
  double smooth_ms = 0.0;
  std::vector<std::string> columns;
  std::string weights;
  std::string out;
  bool json = false;
};

constexpr double kMostSmooth_ms = 1000.0;

/// Processor time of this thread, so that other programs on the machine do not count.
double processor_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

void writePredictions(const PredictOptions& options, const NamedTrace& named, const TrialPlan& plan,
                      const std::vector<Position>& output) {
  std::string text = "t_s";
  for (const std::string& column : named.columns) text += fmt::format(",true_{0},predicted_{0}", column);
  text += '\n';
  for (std::size_t i = 0; i < output.size(); ++i) {
    const std::size_t row = plan.ticks[i].row;
    text += fmt::format("{}", named.trace.time_s[row]);
    for (std::size_t a = 0; a < named.columns.size(); ++a) {
      text += fmt::format(",{},{}", named.trace.position_mm[row][a], output[i][a]);
    }
    text += '\n';
  }
  writeTextFile(options.out, text, {options.trace, options.weights});
}

void runPredict(const PredictOptions& options) {
  const auto choice = predictorNamed(options.predictor);
  if (!choice) throw UsageError(choice.error().message);
  if (auto good = checkNetwork(options.network); !good) throw UsageError(good.error().message);
  if (!(options.smooth_ms >= 0.0 && options.smooth_ms <= kMostSmooth_ms)) {
    throw UsageError(say("--smooth {}: expected 0 … {} ms", options.smooth_ms, kMostSmooth_ms));
  }
  PredictorSetup setup;
  if (!options.weights.empty()) {
    auto weights = StrokeWeights::parse(readTextFile(options.weights));
    if (!weights) throw Failure(about(options.weights, std::move(weights.error().message)));
    setup.weights = std::move(*weights);
  }
  const NamedTrace named = readTrace(options.trace, options.columns);
  if (auto good = checkMessages(named.trace, options.network); !good) {
    throw Failure(about(options.trace, std::move(good.error().message)));
  }
  setup.axes = named.trace.axes;
  setup.period_s = options.network.period_ms * 1e-3;
  const TrialPlan plan = planTrial(named.trace, options.network);
  if (plan.ticks.empty()) {
    throw Failure(say("{}: no message of the trace arrives before it ends ({} rows, delay {} ms, loss {} %)",
                      options.trace, named.trace.time_s.size(), options.network.delay_ms,
                      options.network.loss_percent));
  }
  const auto predictor = makePredictor(*choice, setup);
  const auto order0 = makePredictor(PredictorChoice::order0, setup);
  const double start_ns = processor_ns();
  const std::vector<Position> output = runTrial(named.trace, plan, *predictor, options.smooth_ms * 1e-3);
  const double ns_per_step = (processor_ns() - start_ns) / static_cast<double>(plan.ticks.size());
  const TrialFigures figures = trialFigures(named.trace, plan, output);
  const TrialFigures hold = trialFigures(named.trace, plan, runTrial(named.trace, plan, *order0, 0.0));
  if (!options.out.empty()) writePredictions(options, named, plan, output);

  const nlohmann::ordered_json json{{"predictor", options.predictor},
                                    {"columns", named.columns},
                                    {"ticks", figures.ticks},
                                    {"messages", plan.messages.size()},
                                    {"rms_error_mm", jsonNumber(figures.rms_mm)},
                                    {"mean_error_mm", jsonNumber(figures.mean_mm)},
                                    {"max_error_mm", jsonNumber(figures.max_mm)},
                                    {"order0_rms_mm", jsonNumber(hold.rms_mm)},
                                    {"order0_max_mm", jsonNumber(hold.max_mm)},
                                    {"vibration_ratio", jsonNumber(figures.vibration_ratio)},
                                    {"largest_step_mm", jsonNumber(figures.largest_step_mm)},
                                    {"jerk_ratio", jsonNumber(figures.jerk_ratio)},
                                    {"ns_per_step", jsonNumber(ns_per_step)}};
  printValues(json, options.json);
}

}  // namespace

void add_predict(CLI::App& app) {
  auto options = std::make_shared<PredictOptions>();
  CLI::App* command =
      app.add_subcommand("predict", "How well a recorded motion is known on the far side of a network, by a predictor");
  command->add_option("trace", options->trace, "CSV with t_s and one to three columns in mm; rows of NaN are a gap")
      ->required();
  command->add_option("--predictor", options->predictor, "order0, order1, hybrid, kalman, ar or default")
      ->capture_default_str();
  command->add_option("--period", options->network.period_ms, "Between two messages, ms; 0: each row is a message")
      ->capture_default_str();
  command->add_option("--delay", options->network.delay_ms, "One way, ms")->capture_default_str();
  command->add_option("--jitter", options->network.jitter_ms, "More delay, uniform from 0 to this, ms; may overtake");
  command->add_option("--loss", options->network.loss_percent, "Share of the messages lost, %");
  command->add_option("--seed", options->network.seed, "Seed of jitter and loss")
      ->transform(wholeNumberFrom(0))
      ->capture_default_str();
  command->add_option("--smooth", options->smooth_ms, "Time constant with which a correction decays, ms; 0: none");
  addColumnsOption(*command, options->columns);
  command->add_option("--weights", options->weights,
                      "Another perceptron of train_strokes.py for the default predictor");
  command->add_option("--out", options->out, "Write t_s and each column's true and predicted values, a row per tick");
  command->add_flag("--json", options->json, "Result as JSON; null below 1 kHz, or where the true motion has none");
  command->callback([options] { runPredict(*options); });
}

}  // namespace fyd::cli
