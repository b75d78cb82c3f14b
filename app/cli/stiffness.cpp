// fyd stiffness --target K [--controller pid|thesis] [--plant-scale S] [--noise N] [--delay MS] [--friction PERCENT]
//               [--hysteresis H] [--cloth NAME] [--seed I] [--profile P] [--set id=value] [--course FILE.csv] [--json]
#include <cmath>
#include <iostream>

#include "app/cli/parts/command.h"
#include "app/cli/parts/output_file.h"
#include "app/cli/parts/trial_options.h"

namespace fyd::cli {
namespace {

constexpr double kLeastTarget_N_per_mm = 0.05, kMostTarget_N_per_mm = 3.0;  // pipeline.hand_target_N_per_mm

void writeCourse(const std::string& path, const std::vector<sim::TrialPoint>& course, const std::string& profile) {
  std::string text = "time_s,true_N_per_mm,measured_N_per_mm,stretch_deg\n";
  for (const sim::TrialPoint& point : course) {
    text += (std::isfinite(point.measured_N_per_mm)
                 ? fmt::format("{:.3f},{:.5f},{:.5f},{:.3f}\n", point.time_s, point.true_N_per_mm,
                               point.measured_N_per_mm, point.stretch_deg)
                 : fmt::format("{:.3f},{:.5f},nan,{:.3f}\n", point.time_s, point.true_N_per_mm, point.stretch_deg));
  }
  writeTextFile(path, text, {profile});
}

nlohmann::ordered_json trialJson(const sim::TrialResult& result) {
  return {{"settling_s", jsonNumber(result.settling_s)},
          {"overshoot_pct", jsonNumber(result.overshoot_percent)},
          {"steady_error_pct", jsonNumber(result.steady_error_percent)},
          {"stable", result.stable},
          {"target_clamped", result.target_clamped},
          {"reachable_target_N_per_mm", jsonNumber(result.reachable_target_N_per_mm)},
          {"at_limit", result.at_limit},
          {"stiffness_N_per_mm", jsonNumber(result.final_true_N_per_mm)},
          {"stretch_deg", jsonNumber(result.final_stretch_deg)},
          {"stretch_swing_deg", jsonNumber(result.stretch_swing_deg)}};
}

}  // namespace

void add_stiffness(CLI::App& app) {
  struct Options {
    double target = 0.0;
    std::string controller;
    TrialOptions trial;
    std::string course;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "stiffness", "How fast and how well the touchpad reaches a stiffness: one simulated trial, a held 6 mm press");
  command->add_option("--target", options->target, "Stiffness to reach, N/mm")->required();
  command->add_option("--controller", options->controller, "pid or thesis; the profile's when left out")
      ->check(CLI::IsMember({"pid", "thesis"}));
  options->trial.addTo(*command);
  command->add_option("--course", options->course, "Write the course of the trial as CSV, one row per millisecond");
  command->add_flag("--json", options->json, "As JSON; null stands for what was never reached");
  command->callback([options] {
    requireRange("--target", options->target, kLeastTarget_N_per_mm, kMostTarget_N_per_mm);
    sim::StiffnessTrial trial = options->trial.load();
    trial.target_N_per_mm = options->target;
    if (options->controller == "pid") trial.parameters.control.mode = control::ControlMode::normal;
    if (options->controller == "thesis") sim::useThesisController(trial.parameters.control);
    std::vector<sim::TrialPoint> course;
    const nlohmann::ordered_json json = trialJson(sim::runTrial(trial, &course));
    if (!options->course.empty()) writeCourse(options->course, course, options->trial.profile.file);
    printValues(json, options->json);
  });
}

}  // namespace fyd::cli
