// fyd sim robot: the simulated partners of a session, each as its own process.
#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <csignal>
#include <iostream>
#include <string_view>
#include <thread>

#include "app/cli/command.h"
#include "app/cli/sim_touchpad.h"
#include "core/protocol/link_key_file.h"
#include "core/sim/robot_arm.h"
#include "core/sim/simulated_robot.h"

namespace fyd::cli {
namespace {

// In the order of pipeline::RobotCommand's values.
constexpr std::array<std::string_view, 12> kCommandNames = {"none",
                                                            "vibration-down",
                                                            "vibration-up",
                                                            "dft321",
                                                            "soc",
                                                            "info",
                                                            "resume",
                                                            "images-on",
                                                            "images-off",
                                                            "disconnect",
                                                            "motor-reference-on",
                                                            "motor-reference-off"};

template <class Names>
std::string joined(const Names& names) {
  std::string out;
  for (const std::string_view name : names) out += fmt::format("{}{}", out.empty() ? "" : ", ", name);
  return out;
}

double numberOrUsageError(std::string_view text, std::string_view what) {
  double value = 0.0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || problem != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    throw UsageError(fmt::format("{}: \"{}\" is not a number", what, text));
  }
  return value;
}

sim::TimedCommand parseCommandAt(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) {
    throw UsageError(fmt::format("--command-at \"{}\": expected SECONDS:NAME such as 2.5:vibration-up", text));
  }
  const double at_s = numberOrUsageError(text.substr(0, colon), "--command-at");
  const auto found = std::ranges::find(kCommandNames, text.substr(colon + 1));
  if (at_s < 0.0 || found == kCommandNames.end()) {
    throw UsageError(
        fmt::format("--command-at \"{}\": expected a time of 0 or later and one of {}", text, joined(kCommandNames)));
  }
  return {.at_s = at_s, .command = static_cast<pipeline::RobotCommand>(found - kCommandNames.begin())};
}

pipeline::RobotMotorReference parseMotorReference(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) {
    throw UsageError(fmt::format("--motor-reference \"{}\": expected FIRST,SECOND in ticks", text));
  }
  return {.first_ticks = numberOrUsageError(text.substr(0, comma), "--motor-reference"),
          .second_ticks = numberOrUsageError(text.substr(comma + 1), "--motor-reference")};
}

protocol::Endpoint endpointOrUsageError(const std::string& option, const std::string& text) {
  auto endpoint = protocol::parseEndpoint(text);
  if (!endpoint) throw UsageError(fmt::format("{}: {}", option, endpoint.error().message));
  return *endpoint;
}

volatile std::sig_atomic_t interrupted = 0;
void onInterrupt(int) { interrupted = 1; }

// Runs until Ctrl-C, the termination signal or the robot's own end.
void runUntilInterrupted(sim::SimulatedRobot& robot, Duration limit) {
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
  std::stop_source source;
  std::atomic<bool> finished = false;
  std::jthread watcher([&] {
    while (!finished && interrupted == 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    source.request_stop();
  });
  robot.run(source.get_token(), limit);
  finished = true;
}

nlohmann::ordered_json toJson(const sim::SimulatedRobotStatus& s) {
  const protocol::RobotCounters& c = s.counters;
  return {{"robot", s.description},
          {"bind", protocol::toString(s.local)},
          {"phase", protocol::toString(s.phase)},
          {"seconds", jsonNumber(s.seconds)},
          {"probe", device::toString(s.probe_outcome)},
          {"stiffness_N_per_mm", jsonNumber(s.probed_stiffness_N_per_mm)},
          {"connections", s.connections},
          {"states_sent", c.states},
          {"touches_received", c.touches},
          {"missed_replies", c.missed_replies},
          {"extra_touches", c.extra_touches},
          {"waited_cycles", c.waited_cycles},
          {"cycles_cut_short", c.cycles_cut_short},
          {"infos_received", c.infos},
          {"images_received", c.images},
          {"motor_references_sent", c.motor_references},
          {"acks_sent", c.acks},
          {"touchpad_lost", c.lost},
          {"refused_datagrams", c.refused},
          {"wrong_peer_datagrams", c.wrong_peer},
          {"missed_cycles", s.missed_cycles},
          {"send_failures", s.send_failures},
          {"robot_errors", s.robot_errors},
          {"problem", s.problem}};
}

struct RobotOptions {
  std::string connect;
  std::string bind = "127.0.0.2:3490";
  std::string material = "rubber";
  double stiffness = 0.0;
  int seed = 1;
  double duration_s = 0.0;
  double rate_Hz = 1000.0;
  std::vector<std::string> commands;
  std::string motor_reference = "0,0";
  std::string waits = "modern";
  bool link = false;
  std::string key;
  double state_rate_Hz = 100.0;
  bool json = false;
};

void runRobot(const RobotOptions& given) {
  sim::SimulatedRobotOptions options;
  options.touchpad = endpointOrUsageError("--connect", given.connect);
  options.bind = endpointOrUsageError("--bind", given.bind);
  options.rate_Hz = given.rate_Hz;
  options.motor_reference = parseMotorReference(given.motor_reference);
  if (given.waits == "wired") options.link = protocol::ClassicRobotSettings::wired();
  if (given.waits == "wireless") options.link = protocol::ClassicRobotSettings::wireless();
  if (given.link != !given.key.empty()) {
    throw UsageError(given.link ? "--link: FYD Link needs --key FILE; fyd link keygen makes one"
                                : "--key: only FYD Link takes a key; add --link");
  }
  if (given.link) options.key = valueOrFail(protocol::readKeyFile(given.key));
  options.secure.rates.state_Hz = given.state_rate_Hz;
  options.secure.text = "fyd sim robot " FYD_VERSION;
  for (const std::string& text : given.commands) options.commands.push_back(parseCommandAt(text));

  sim::SimParameters parameters;
  parameters.seed = given.seed;
  parameters.material_stiffness_N_per_mm = given.stiffness;
  parameters.material =
      static_cast<sim::Material>(std::ranges::find(sim::kMaterialNames, given.material) - sim::kMaterialNames.begin());

  const auto robot = valueOrFail(sim::SimulatedRobot::open(options, std::make_unique<sim::RobotArm>(parameters)));
  const sim::SimulatedRobotStatus at_start = robot->status();
  std::cerr << fmt::format("{}: probe {}, {:.3f} N/mm; calling {} from {}\n", at_start.description,
                           device::toString(at_start.probe_outcome), at_start.probed_stiffness_N_per_mm,
                           protocol::toString(options.touchpad), protocol::toString(robot->local()));
  runUntilInterrupted(*robot, given.duration_s > 0.0 ? fromSeconds(given.duration_s) : Duration::max());

  const sim::SimulatedRobotStatus status = robot->status();
  const nlohmann::ordered_json summary = toJson(status);
  if (given.json) {
    printJson(summary);
  } else {
    for (const auto& [key, value] : summary.items()) {
      std::cout << fmt::format("{:<24}{}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
    }
  }
  if (status.connections == 0) {
    throw Failure(
        fmt::format("{}: {} in {:.1f} s", protocol::toString(options.touchpad), status.problem, status.seconds));
  }
}

void addRobot(CLI::App& sim) {
  auto options = std::make_shared<RobotOptions>();
  CLI::App* robot = sim.add_subcommand("robot", "The robot's end of either protocol with a simulated arm");
  robot->add_flag("--link", options->link, "Speak FYD Link (secured) in place of the classic protocol; needs --key");
  robot->add_option("--key", options->key, "Key file of FYD Link");
  robot->add_option("--state-rate", options->state_rate_Hz, "States a second to ask for over FYD Link")
      ->check(CLI::Range(1.0, 1'000.0))
      ->capture_default_str();
  robot->add_option("--connect", options->connect, "Touchpad to call, HOST:PORT")->required();
  robot->add_option("--bind", options->bind, "Own address, HOST:PORT; port 0: any")->capture_default_str();
  robot->add_option("--material", options->material, "What lies under the tool")
      ->check(CLI::IsMember(std::vector<std::string>(sim::kMaterialNames.begin(), sim::kMaterialNames.end())))
      ->capture_default_str();
  robot->add_option("--stiffness", options->stiffness, "N/mm in place of the material's own; 0 keeps that")
      ->check(CLI::Range(0.0, 1000.0));
  robot->add_option("--seed", options->seed, "Seed of its noise")->check(CLI::Range(0, 1'000'000'000));
  robot->add_option("--duration", options->duration_s, "Seconds to run; 0: until Ctrl-C or command disconnect")
      ->check(CLI::Range(0.0, 1e9));
  robot
      ->add_option("--rate", options->rate_Hz,
                   "Cycles a second; each sends a state (classic) or a sample in one (link)")
      ->check(CLI::Range(1.0, 10'000.0))
      ->capture_default_str();
  robot->add_option("--command-at", options->commands,
                    "SECONDS:NAME, a command of the robot's operator that long after the first handshake; repeatable. "
                    "Names: " +
                        joined(kCommandNames));
  robot->add_option("--motor-reference", options->motor_reference, "FIRST,SECOND ticks, sent after motor-reference-on");
  robot
      ->add_option("--waits", options->waits,
                   "For a reply: modern (100 ms, then on), wired (for ever) or wireless (1 s, twice), as the authors'")
      ->check(CLI::IsMember({"modern", "wired", "wireless"}))
      ->capture_default_str();
  robot->add_flag("--json", options->json, "Summary as JSON");
  robot->callback([options] { runRobot(*options); });
}

}  // namespace

void add_sim(CLI::App& app) {
  CLI::App* sim = app.add_subcommand("sim", "Simulated partners that speak the real protocols");
  sim->require_subcommand(1);
  addRobot(*sim);
  addSimTouchpad(*sim);
}

}  // namespace fyd::cli
