// The stiffness loop through the whole simulated chain, the thesis' PI beside it: settling, overshoot and error by
// case, a Monte-Carlo of unkind plants, and the time of one controller step.
#include <cmath>
#include <future>
#include <random>

#include "app/cli/bench/cloths.h"
#include "app/cli/bench/table.h"
#include "core/control/stiffness_controller.h"
#include "core/sim/stiffness_trial.h"

namespace fyd::bench {
namespace {

constexpr int kMonteCarloRuns = 2000;
constexpr int kSeeds = 10;

struct Case {
  std::string name;
  std::vector<sim::StiffnessTrial> trials;
};

sim::StiffnessTrial trialOf(double target, double scale, int seed) {
  sim::StiffnessTrial trial;
  trial.target_N_per_mm = target;
  trial.sim.fabric_stiffness_scale = scale;
  trial.sim.seed = seed;
  return trial;
}

std::vector<Case> cases() {
  std::vector<Case> all(5);
  all[0].name = "nominal, 0.50…0.71 N/mm";
  all[1].name = "cloth +30 %, reachable";
  all[2].name = "cloth −30 %, reachable";
  all[3].name = "out of reach";
  all[4].name = fmt::format("Monte-Carlo, {} runs", kMonteCarloRuns);
  for (int seed = 1; seed <= kSeeds; ++seed) {
    for (const double target : {0.50, 0.54, 0.58, 0.62, 0.66, 0.71})
      all[0].trials.push_back(trialOf(target, 1.0, seed));
    for (const double target : {0.68, 0.74, 0.80, 0.86, 0.91}) all[1].trials.push_back(trialOf(target, 1.3, seed));
    for (const double target : {0.37, 0.40, 0.43, 0.46, 0.49}) all[2].trials.push_back(trialOf(target, 0.7, seed));
    for (const auto& [target, scale] : {std::pair{0.9, 1.0}, {0.3, 1.0}, {0.55, 1.3}, {0.6, 0.7}}) {
      all[3].trials.push_back(trialOf(target, scale, seed));
    }
  }
  std::mt19937_64 random(2014);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int run = 0; run < kMonteCarloRuns; ++run) {
    sim::StiffnessTrial trial = trialOf(0.45 + 0.35 * uniform(random), 0.7 + 0.6 * uniform(random), run);
    sim::scaleNoise(trial.sim, 3 * uniform(random));
    sim::delaySensors(trial.sim, 100 * uniform(random));
    trial.sim.motor_friction_percent = 20 * uniform(random);
    trial.duration_s = 4;
    all[4].trials.push_back(trial);
  }
  return all;
}

enum class Controller : std::uint8_t { thesis, as_delivered, trusting };
constexpr std::array<const char*, 3> kControllers = {"baseline: thesis PI", "default", "default, measurement_bias 0"};

std::vector<sim::TrialResult> runAll(const std::vector<sim::StiffnessTrial>& trials, Controller controller,
                                     sim::ClothKind cloth) {
  const auto run = [&](std::size_t begin, std::size_t step) {
    std::vector<sim::TrialResult> out;
    for (std::size_t i = begin; i < trials.size(); i += step) {
      sim::StiffnessTrial trial = trials[i];
      trial.sim.cloth = cloth;
      if (controller == Controller::thesis) sim::useThesisController(trial.parameters.control);
      if (controller == Controller::trusting) trial.parameters.control.measurement_bias = 0.0;
      out.push_back(sim::runTrial(trial));
    }
    return out;
  };
  auto other = std::async(std::launch::async, run, 1, 2);
  std::vector<sim::TrialResult> results = run(0, 2);
  for (const sim::TrialResult& result : other.get()) results.push_back(result);
  return results;
}

std::vector<std::string> row(sim::ClothKind cloth, const std::string& name, const std::string& controller,
                             const std::vector<sim::TrialResult>& results) {
  std::vector<double> settling;
  double overshoot = 0.0, error = 0.0, worst_error = 0.0, swing = 0.0;
  int settled = 0, unstable = 0;
  for (const sim::TrialResult& result : results) {
    settling.push_back(std::isnan(result.settling_s) ? 1e9 : result.settling_s);
    settled += std::isnan(result.settling_s) ? 0 : 1;
    unstable += result.stable ? 0 : 1;
    overshoot = std::max(overshoot, result.overshoot_percent);
    error += result.steady_error_percent / static_cast<double>(results.size());
    worst_error = std::max(worst_error, result.steady_error_percent);
    swing += result.stretch_swing_deg / static_cast<double>(results.size());
  }
  const Quantiles q = quantiles(settling);
  const auto time = [](double value) { return value > 1e8 ? std::string("never") : number(value); };
  return {std::string(sim::kClothNames[static_cast<std::size_t>(cloth)]),
          name,
          controller,
          fmt::format("{}", results.size()),
          time(q.p50),
          time(q.worst),
          fmt::format("{} %", 100 * settled / static_cast<int>(results.size())),
          number(overshoot),
          number(error),
          number(worst_error),
          number(swing),
          fmt::format("{}", unstable)};
}

double stepTime_ns(bool thesis) {
  control::ControlParameters parameters;
  if (thesis) sim::useThesisController(parameters);
  control::StiffnessController controller(parameters);
  control::ControlInput input{.target_N_per_mm = 0.6,
                              .measured_N_per_mm = 0.58,
                              .measured_sigma_N_per_mm = 0.03,
                              .observable = true,
                              .measured_angle_deg = 50.0,
                              .measured_angle_known = true,
                              .enabled = true};
  double time_s = 0.0;
  auto times = timeEach(20000, [&] {
    input.now = instantAt(time_s += 0.001);
    input.measured_N_per_mm = 0.58 + 0.02 * std::sin(40 * time_s);
    (void)controller.step(input);
  });
  return quantiles(times).p50;
}

}  // namespace

Table bench_controller() {
  Table table;
  table.subject = "controller";
  table.title = "Stiffness controller against the thesis' PI";
  table.columns = {"cloth",   "case",          "controller",       "runs",      "settling p50 (s)",  "worst (s)",
                   "settled", "overshoot (%)", "steady error (%)", "worst (%)", "stretch swing (°)", "unstable"};
  for (const sim::ClothKind cloth : benchCloths()) {
    for (const Case& each : cases()) {
      for (std::size_t i = 0; i < kControllers.size(); ++i) {
        table.rows.push_back(
            row(cloth, each.name, kControllers[i], runAll(each.trials, static_cast<Controller>(i), cloth)));
      }
    }
  }
  const double thesis_ns = stepTime_ns(true), default_ns = stepTime_ns(false);
  table.notes = {
      "Held press of 6 mm, motors from 20° at 180 °/s at most, sensors with noise, sensing and pipeline in between; "
      "judged on the "
      "cloth's true stiffness. Settling: into ±5 % of the target for good. Overshoot and errors in % of the target.",
      "Monte-Carlo: cloth ±30 %, target 0.45…0.80 N/mm (some out of reach), noise 0…3 times, dead time of every sensor "
      "0…100 ms, motor friction 0…20 % duty; 4 s each. The other cases: 8 s, seeds 1…10.",
      "A cloth +30 % overshoots because the feed-forward, which is quick, believes the calibration until the sensors "
      "know better.",
      "The thesis gives no gains; the baseline's are a hand-tuned guess (control.thesis_kp, control.thesis_ki) with "
      "its own "
      "static law as rest position.",
      fmt::format(
          "One controller step, median: default {} ns, thesis {} ns (most steps of the thesis do nothing), ratio {}.",
          number(default_ns), number(thesis_ns), number(default_ns / thesis_ns))};
  return table;
}

}  // namespace fyd::bench
