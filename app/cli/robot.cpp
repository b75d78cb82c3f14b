// fyd robot: the robot end of a session [thesis §4.2], with a simulated arm or a KUKA LWR.
#include <algorithm>
#include <optional>

#include "app/cli/parts/end_options.h"
#include "app/cli/parts/process_options.h"
#include "core/device/robot/fri_robot.h"
#include "core/protocol/link/described_scene.h"
#include "core/sim/robot/robot_arm.h"
#include "core/sim/robot/scene_arm.h"

namespace fyd::cli {
namespace {

constexpr std::string_view kKuka = "kuka:";
constexpr std::string_view kUsualAxes = "-y,-x,z", kUsualSmoothing = "0.8,0.9";

struct RobotCliOptions {
  EndOptions end;
  MaterialOptions material;
  std::string arm = "simulated";
  std::string scene;
  std::optional<std::string> axes;
  std::optional<std::string> krc;
  bool no_probe = false;
  std::optional<double> known_stiffness;
  std::string probe_estimate = "slope";
  device::ProbeSettings probe;
  std::string scale = "1,3";
  std::optional<std::string> smoothing;
  std::string predictor = "default";
  double smooth_ms = device::TouchReferenceSettings{}.smooth_ms;
  std::optional<double> arm_lag_ms;
  std::string workspace = "35,25,70";
  device::MotionLimits limits;
};

protocol::TouchMappingSettings mappingOf(const RobotCliOptions& given) {
  const auto scale = numbersOrUsageError("--scale", given.scale, 2);
  const std::string smoothing = given.smoothing.value_or(std::string(kUsualSmoothing));
  const auto keep = numbersOrUsageError("--smoothing", smoothing, 2);
  if (std::ranges::min(scale) < 0.0 || std::ranges::max(scale) > 20.0) {
    throw UsageError(say("--scale {}: expected two factors of 0 to 20", given.scale));
  }
  if (std::ranges::min(keep) < 0.0 || std::ranges::max(keep) >= 1.0) {
    throw UsageError(say("--smoothing {}: expected two shares of 0 to below 1", smoothing));
  }
  return {.scale_xy = scale[0], .scale_z = scale[1], .keep_xy = keep[0], .keep_z = keep[1]};
}

nlohmann::ordered_json armJson(const device::FriRobot& robot) {
  const device::FriCounters& c = robot.counters();
  const protocol::FriMeasurement* newest = robot.measurement();
  std::uint64_t refused = 0;
  for (const std::uint64_t count : c.refused) refused += count;
  return {{"mode", newest != nullptr ? protocol::toString(newest->state) : "unknown"},
          {"quality", newest != nullptr ? protocol::toString(newest->quality) : "unknown"},
          {"measurements", c.measurements},
          {"answers", c.answers},
          {"out_of_order", c.out_of_order},
          {"refused_datagrams", refused},
          {"wrong_peer_datagrams", c.wrong_peer},
          {"impossible_measurements", c.impossible},
          {"send_failures", c.send_failures},
          {"command_entries", c.command_entries},
          {"answers_not_taken", c.not_taken}};
}

/// What --arm kuka:… takes; nothing with another arm, which takes neither --axes nor --krc.
std::optional<device::FriSettings> kukaOf(const RobotCliOptions& given) {
  device::FriSettings settings;
  if (given.krc) settings.krc = endpointOrUsageError("--krc", *given.krc + ":0");
  const auto axes = device::parseAxisMap(given.axes.value_or(std::string(kUsualAxes)));
  if (!axes) throw UsageError(about("--axes", axes.error().message));
  settings.axes = *axes;
  if (given.scene.empty() && given.arm.starts_with(kKuka)) {
    settings.bind = endpointOrUsageError("--arm", given.arm.substr(kKuka.size()));
    return settings;
  }
  if (given.scene.empty() && given.arm != "simulated") {
    throw UsageError(say("--arm \"{}\": expected simulated or kuka:HOST:PORT", given.arm));
  }
  if (given.axes) throw CLI::RequiresError("--axes", "--arm kuka:HOST:PORT");
  if (given.krc) throw CLI::RequiresError("--krc", "--arm kuka:HOST:PORT");
  return {};
}

void runRobot(const RobotCliOptions& given) {
  const auto kuka = kukaOf(given);
  const auto mapping = mappingOf(given);
  const auto following = device::followingNamed(given.predictor);
  if (!following) throw UsageError(about("--predictor", following.error().message));
  if (given.smoothing && given.predictor != "thesis") throw CLI::RequiresError("--smoothing", "--predictor thesis");
  if (given.known_stiffness && !given.no_probe && given.scene.empty()) {  // a scene is never probed
    throw CLI::RequiresError("--known-stiffness", "--no-probe");
  }
  const auto workspace = numbersOrUsageError("--workspace", given.workspace, 3);
  device::MotionLimits limits = given.limits;
  limits.workspace_mm = {workspace[0], workspace[1], workspace[2]};
  if (auto good = device::checkLimits(limits); !good) throw UsageError(good.error().message);

  // Opens the key's file: after all that is wrong without looking.
  device::RobotRunnerOptions options = runnerOptions(given.end, "fyd robot " FYD_VERSION);
  options.reference.mapping = mapping;
  options.reference.predictor = *following;
  options.reference.smooth_ms = given.smooth_ms;
  options.reference.lead_ms = given.arm_lag_ms;
  options.limits = limits;
  options.probe = given.probe;
  options.probe.estimate = given.probe_estimate == "slope"  ? device::ProbeEstimate::slope
                           : given.probe_estimate == "mean" ? device::ProbeEstimate::mean
                                                            : device::ProbeEstimate::thesis;
  options.probe_material = !given.no_probe;
  options.known_stiffness_N_per_mm = given.known_stiffness.value_or(0.0);

  if (!given.scene.empty()) {
    options.probe_material = false;
    auto arm = valueOrFail(sim::SceneArm::open(given.scene, options.rate_Hz));
    const std::string text = protocol::describedWith(options.secure.text, arm->digest());
    options.secure.text = text;
    runRobotEnd(given.end, options, std::move(arm), {});
    return;
  }
  if (!kuka) {
    runRobotEnd(given.end, options, std::make_unique<sim::RobotArm>(simParameters(given.material)), {});
    return;
  }
  auto arm = valueOrFail(device::FriRobot::open(*kuka));
  // The runner owns it from here on and is alive when the summary is made. Asked before it is moved: of two arguments the
  // compiler may make either first.
  const device::FriRobot* fri = arm.get();
  runRobotEnd(given.end, options, std::move(arm), [fri] { return armJson(*fri); });
}

/// Options that a run like this one would take no notice of.
void refuseUseless(const CLI::App& robot, const RobotCliOptions& given) {
  const auto refuse = [&robot](const char* beside, std::initializer_list<const char*> useless) {
    for (const char* option : useless) {
      if (robot.count(option) > 0) throw CLI::ExcludesError(option, beside);
    }
  };
  const bool kuka = given.scene.empty() && given.arm.starts_with(kKuka);
  if (kuka) refuse("--arm kuka:HOST:PORT", {"--material", "--stiffness", "--seed"});
  if (!given.scene.empty()) refuse("--scene", {"--material", "--stiffness", "--seed"});
  if (given.no_probe) refuse("--no-probe", {"--probe-travel", "--probe-force", "--probe-dwell", "--probe-estimate"});
}

}  // namespace

void add_robot(CLI::App& app) {
  auto options = std::make_shared<RobotCliOptions>();
  CLI::App* robot =
      app.add_subcommand("robot", "The robot end: probes the material, calls the touchpad, moves the arm");
  addEndOptions(*robot, options->end);
  robot
      ->add_option("--arm", options->arm,
                   "simulated, or kuka:HOST:PORT, the own address to which the LWR's controller sends (port 49938)")
      ->capture_default_str();
  robot->add_option("--scene", options->scene, "Scene file that stands in the arm's place")->excludes("--arm");
  robot->add_option("--krc", options->krc, "Accept this host as the controller only");
  robot->add_option("--axes", options->axes, "Our axes along the LWR's base X, Y, Z")
      ->default_str(std::string(kUsualAxes));
  addMaterialOptions(*robot, options->material);
  robot->add_flag("--no-probe", options->no_probe, "Do not probe the material");
  robot->add_option("--known-stiffness", options->known_stiffness, "N/mm to tell the touchpad with --no-probe")
      ->check(numberFrom(0.0, 1000.0));
  robot->add_option("--probe-travel", options->probe.travel_limit_mm, "Deepest the probe goes, mm")
      ->check(numberFrom(1.0, 70.0))
      ->capture_default_str();
  robot->add_option("--probe-force", options->probe.force_limit_N, "Force at which the probe goes back, N")
      ->check(numberFrom(1.0, 50.0))
      ->capture_default_str();
  robot->add_option("--probe-dwell", options->probe.dwell_s, "Wait at each step of the probe, s")
      ->check(numberFrom(0.02, 5.0))
      ->capture_default_str();
  robot->add_option("--probe-estimate", options->probe_estimate, "Stiffness from the samples")
      ->check(CLI::IsMember({"slope", "mean", "thesis"}))
      ->capture_default_str();
  robot->add_option("--scale", options->scale, "XY,Z: movement of the robot divided by that of the finger")
      ->capture_default_str();
  robot
      ->add_option("--predictor", options->predictor,
                   "How the arm is led: default, order0, order1, hybrid, kalman or ar say where the finger is now; "
                   "thesis keeps a share of the old target at each touch")
      ->capture_default_str();
  robot->add_option("--smooth", options->smooth_ms, "Time in which a prediction's correction decays, ms")
      ->check(numberFrom(0.0, 1000.0))
      ->capture_default_str();
  robot
      ->add_option(
          "--arm-lag", options->arm_lag_ms,
          "Delay of the tool behind the commands to the arm, ms; it is predicted too. The simulated arm knows its own, "
          "the KUKA does not")
      ->check(numberFrom(0.0, 500.0));
  robot->add_option("--smoothing", options->smoothing, "XY,Z: share of the old target kept at each touch, of thesis")
      ->default_str(std::string(kUsualSmoothing));
  robot->add_option("--workspace", options->workspace, "X,Y,Z: largest distances from the start, mm")
      ->capture_default_str();
  robot->add_option("--speed-limit", options->limits.speed_mm_s, "mm/s")->capture_default_str();
  robot->add_option("--acceleration-limit", options->limits.acceleration_mm_s2, "mm/s²")->capture_default_str();
  robot->add_option("--jerk-limit", options->limits.jerk_mm_s3, "mm/s³")->capture_default_str();
  robot->callback([options, robot] {
    refuseUseless(*robot, *options);
    runRobot(*options);
  });
}

}  // namespace fyd::cli
