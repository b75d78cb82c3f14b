// The stiffness loop through the whole simulated chain, the thesis' PI and the law alone beside it: settling, overshoot
// and error by case, a Monte Carlo run over unfavourable plants, and the time of one controller step.
#include <cmath>
#include <future>
#include <random>
#include <span>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/calibrated_cloth.h"
#include "app/bench/parts/cloths.h"
#include "app/bench/parts/page_run.h"
#include "app/bench/parts/table.h"
#include "core/control/stiffness_controller.h"
#include "core/sim/cloth/cloth.h"
#include "core/sim/trial/stiffness_trial.h"

namespace fyd::bench {
namespace {

int monteCarloRuns() { return wholePageOrQuick(2000, 200, 6); }
int seeds() { return wholePageOrQuick(10, 3, 1); }
constexpr std::array<std::pair<double, double>, 9> kPlaces_mm{
    {{0, 0}, {22, -3}, {0, 20}, {-25, 12}, {15, -18}, {-35, 0}, {30, 15}, {-10, -10}, {10, 5}}};

struct Case {
  std::string name;
  std::vector<sim::StiffnessTrial> trials;
};

sim::StiffnessTrial trialOf(sim::ClothKind cloth, double scale, int seed) {
  sim::StiffnessTrial trial;
  trial.sim.cloth = cloth;
  trial.sim.cloth_stiffness_scale = scale;
  trial.sim.seed = seed;
  return trial;
}

void makeUnkind(sim::StiffnessTrial& trial, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  sim::scaleNoise(trial.sim, 3 * uniform(random));
  sim::delaySensors(trial.sim, 100 * uniform(random));
  trial.sim.motor_friction_percent = 20 * uniform(random);
  trial.duration_s = 4;
}

/// Presses in the middle, 6 mm deep, of the ideal cloth, which is uniform.
std::vector<Case> idealCases() {
  std::vector<Case> all(5);
  all[0].name = "nominal, 0.50…0.71 N/mm";
  all[1].name = "cloth +30 %, reachable";
  all[2].name = "cloth −30 %, reachable";
  all[3].name = "out of reach";
  all[4].name = fmt::format("Monte-Carlo, {} runs", monteCarloRuns());
  const auto add = [](Case& to, double target, double scale, int seed) {
    sim::StiffnessTrial trial = trialOf(sim::ClothKind::ideal, scale, seed);
    trial.parameters.sensing.indentation.mode = sensing::IndentationMode::membrane;  // right on this cloth
    trial.target_N_per_mm = target;
    to.trials.push_back(trial);
  };
  for (int seed = 1; seed <= seeds(); ++seed) {
    for (const double target : {0.50, 0.54, 0.58, 0.62, 0.66, 0.71}) add(all[0], target, 1.0, seed);
    for (const double target : {0.68, 0.74, 0.80, 0.86, 0.91}) add(all[1], target, 1.3, seed);
    for (const double target : {0.37, 0.40, 0.43, 0.46, 0.49}) add(all[2], target, 0.7, seed);
    for (const auto& [target, scale] : {std::pair{0.9, 1.0}, {0.3, 1.0}, {0.55, 1.3}, {0.6, 0.7}}) {
      add(all[3], target, scale, seed);
    }
  }
  std::mt19937_64 random(2014);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int run = 0; run < monteCarloRuns(); ++run) {
    const double target = 0.45 + 0.35 * uniform(random);
    add(all[4], target, 0.7 + 0.6 * uniform(random), run);
    makeUnkind(all[4].trials.back(), random);
  }
  return all;
}

/// The target is the cloth's stiffness at this stretch, place and depth, so it is reachable. A press that would
/// overload the load cell (19.5 N: the session holds) at the end of the travel is less deep.
sim::StiffnessTrial inReach(sim::StiffnessTrial trial, double angle_deg) {
  constexpr double kMost_N = 16.0;
  const sim::Cloth cloth(trial.sim);
  const auto stiffness = [&](double deg) {
    return cloth.stiffness(deg,
                           {.x_mm = trial.x_mm, .y_mm = trial.y_mm, .indentation_mm = trial.press_mm, .lifted = false});
  };
  while (trial.press_mm * stiffness(trial.parameters.control.travel_maximum_deg) > kMost_N) trial.press_mm *= 0.9;
  trial.target_N_per_mm = stiffness(angle_deg);
  return trial;
}

/// Nine places, three depths, targets in reach; and plants drawn at random.
std::vector<Case> solvedCases(sim::ClothKind cloth) {
  std::vector<Case> all(3);
  all[0].name = "nine places, 3…6 mm";
  all[1].name = "the same, cloth ±30 %";
  all[2].name = fmt::format("Monte-Carlo, {} runs", monteCarloRuns());
  int seed = 0;
  for (const auto& [x, y] : std::span(kPlaces_mm).first(wholeOrQuick<std::size_t>(kPlaces_mm.size(), 1))) {
    for (const double depth : {3.0, 4.5, 6.0}) {
      for (const double scale : {1.0, 0.7, 1.3}) {
        for (const double angle_deg : {30.0, 55.0, 80.0}) {
          sim::StiffnessTrial trial = trialOf(cloth, scale, ++seed);
          trial.x_mm = x;
          trial.y_mm = y;
          trial.press_mm = depth;
          trial.duration_s = 6;
          all[scale == 1.0 ? 0 : 1].trials.push_back(inReach(trial, angle_deg));
        }
      }
    }
  }
  std::mt19937_64 random(2014);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int run = 0; run < monteCarloRuns(); ++run) {
    sim::StiffnessTrial trial = trialOf(cloth, 0.7 + 0.6 * uniform(random), run);
    trial.sim.finger = static_cast<sim::FingerKind>(run % static_cast<int>(sim::kFingerNames.size()));
    trial.x_mm = 66 * (uniform(random) - 0.5);
    trial.y_mm = (cloth == sim::ClothKind::rollers ? 24 : 36) * (uniform(random) - 0.5);
    trial.press_mm = 2 + 5 * uniform(random);
    const double angle_deg = 25 + 60 * uniform(random);
    makeUnkind(trial, random);
    all[2].trials.push_back(inReach(trial, angle_deg));
  }
  return all;
}

enum class Controller : std::uint8_t { thesis, law_alone, as_delivered, trusting, calibrated };

const char* nameOf(Controller controller) {
  switch (controller) {
    case Controller::thesis: return "baseline: thesis PI";
    case Controller::law_alone: return "law alone";
    case Controller::as_delivered: return "default";
    case Controller::trusting: return "default, measurement_bias 0";
    case Controller::calibrated: return "cloth calibrated";
  }
  return "";
}

std::vector<Controller> controllersOn(sim::ClothKind cloth) {
  if (cloth == sim::ClothKind::ideal) return {Controller::thesis, Controller::as_delivered, Controller::trusting};
  return {Controller::thesis, Controller::law_alone, Controller::as_delivered, Controller::calibrated};
}

/// One calibration for each finger.
using Calibrations = std::array<pipeline::Parameters, sim::kFingerNames.size()>;

Calibrations calibrationsOf(sim::ClothKind cloth) {
  Calibrations out;
  if (cloth == sim::ClothKind::ideal) return out;
  for (std::size_t finger = 0; finger < out.size(); ++finger) {
    sim::SimParameters parameters;
    parameters.cloth = cloth;
    parameters.finger = static_cast<sim::FingerKind>(finger);
    out[finger] = calibratedOn(parameters);
  }
  return out;
}

std::vector<sim::TrialResult> runAll(const std::vector<sim::StiffnessTrial>& trials, Controller controller,
                                     const Calibrations& calibrations) {
  const auto run = [&](std::size_t begin, std::size_t step) {
    std::vector<sim::TrialResult> out;
    for (std::size_t i = begin; i < trials.size(); i += step) {
      sim::StiffnessTrial trial = trials[i];
      if (controller == Controller::calibrated) {
        trial.parameters = calibrations[static_cast<std::size_t>(trial.sim.finger)];
      }
      control::ControlParameters& control = trial.parameters.control;
      if (controller == Controller::thesis) {
        sim::useThesisController(control);
        trial.parameters.sensing.indentation.mode = sensing::IndentationMode::membrane;
      }
      if (controller == Controller::trusting) control.measurement_bias = 0.0;
      if (controller == Controller::law_alone) control.measurement_bias = 1.0;
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
  int settled = 0, unstable = 0, within_5 = 0, within_15 = 0, stopped = 0;
  for (const sim::TrialResult& result : results) {
    settling.push_back(std::isnan(result.settling_s) ? 1e9 : result.settling_s);
    settled += std::isnan(result.settling_s) ? 0 : 1;
    unstable += result.stable ? 0 : 1;
    within_5 += result.steady_error_percent <= 5 ? 1 : 0;
    within_15 += result.steady_error_percent <= 15 ? 1 : 0;
    stopped += result.at_limit && result.reachable ? 1 : 0;
    overshoot = std::max(overshoot, result.overshoot_percent);
    error += result.steady_error_percent / static_cast<double>(results.size());
    worst_error = std::max(worst_error, result.steady_error_percent);
    swing += result.stretch_swing_deg / static_cast<double>(results.size());
  }
  const Quantiles q = quantiles(settling);
  const auto time = [](double value) { return value > 1e8 ? kNever : number(value); };
  const auto part = [&](int of) { return fmt::format("{:.0f} %", 100.0 * of / static_cast<double>(results.size())); };
  return {std::string(sim::kClothNames[static_cast<std::size_t>(cloth)]),
          name,
          controller,
          fmt::format("{}", results.size()),
          time(q.p50),
          time(q.worst),
          part(settled),
          number(overshoot),
          number(error),
          number(worst_error),
          part(within_5),
          part(within_15),
          number(swing),
          fmt::format("{}", stopped),
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
  return quantiles(times).p50 - clockTime_ns();
}

}  // namespace

Table bench_controller() {
  Table table;
  table.subject = "controller";
  table.title = "Stiffness controller against the thesis' PI";
  table.columns = {{"cloth", Role::group},
                   {"case", Role::group},
                   {"controller", Role::method},
                   "runs",
                   {"settling p50", "s", Role::cost},
                   {"worst", "s"},
                   "settled",
                   {"overshoot", "%"},
                   {"error", "%", Role::error},
                   {"worst", "%"},
                   "within 5 %",
                   "within 15 %",
                   {"stretch swing", "°"},
                   "at a stop",
                   "unstable"};
  for (const sim::ClothKind cloth : benchCloths()) {
    const Calibrations calibrations = calibrationsOf(cloth);
    for (const Case& each : cloth == sim::ClothKind::ideal ? idealCases() : solvedCases(cloth)) {
      for (const Controller controller : controllersOn(cloth)) {
        table.rows.push_back(row(cloth, each.name, nameOf(controller), runAll(each.trials, controller, calibrations)));
      }
    }
  }
  const double thesis_ns = stepTime_ns(true), default_ns = stepTime_ns(false);
  table.notes = {
      "A held press, motors from 20° at 180 °/s at most, sensors with noise, sensing and pipeline in between; judged "
      "on "
      "the cloth's true stiffness where the finger is. Settling: into ±5 % of the target for good. Error: over the "
      "last "
      "quarter, in % of the target. At a stop: of the stretch, though the target is in reach.",
      fmt::format("ideal: 6 mm deep in the middle, the sensing mode that is right there; 8 s, seeds 1…{}. Monte-Carlo: "
                  "cloth ±30 "
                  "%, "
                  "target 0.45…0.80 N/mm (some out of reach), noise 0…3 times, dead time of every sensor 0…100 ms, "
                  "motor friction "
                  "0…20 % duty; 4 s.",
                  seeds()),
      "membrane, rollers: solved in finite strain; targets are what the cloth gives at 30, 55 and 80° of stretch at "
      "that "
      "place and depth; 6 s. Monte-Carlo: sphere, capsule and disc in turn, anywhere on the cloth, 2…7 mm deep, the "
      "rest "
      "as above, all in reach. Cloth calibrated: nine presses over the sensors, one calibration for each finger. The "
      "thesis' PI has the membrane mode.",
      ("A cloth +30 % overshoots because the feed-forward, which is quick, believes the calibration until the sensors "
       "know better."),
      ("The thesis gives no gains; the baseline's are a hand-tuned guess (control.thesis_kp, control.thesis_ki) with "
       "its own "
       "static law as rest position."),
      fmt::format(
          "One controller step, median: default {} ns, thesis {} ns (most steps of the thesis do nothing), ratio {}.",
          number(default_ns), number(thesis_ns), number(default_ns / thesis_ns))};
  return table;
}

}  // namespace fyd::bench
