#include "app/cli/parts/end_options.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <string_view>
#include <utility>

#include "app/cli/parts/process_options.h"
#include "core/protocol/link/described_scene.h"
#include "core/protocol/link/link_key_file.h"

namespace fyd::cli {
namespace {

constexpr Duration kTellAgain = std::chrono::seconds(5);

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

device::TimedCommand parseCommandAt(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) {
    throw UsageError(say("--command-at \"{}\": expected SECONDS:NAME such as 2.5:vibration-up", text));
  }
  const double at_s = numberOrUsageError("--command-at", text.substr(0, colon));
  const auto found = std::ranges::find(kCommandNames, text.substr(colon + 1));
  if (at_s < 0.0 || found == kCommandNames.end()) {
    throw UsageError(
        say("--command-at \"{}\": expected a time of 0 or later and one of {}", text, joined(kCommandNames)));
  }
  return {.at_s = at_s, .command = static_cast<pipeline::RobotCommand>(found - kCommandNames.begin())};
}

protocol::SceneCopies scenesOf(const device::RobotRunnerStatus& s, std::string_view own_text) {
  if (s.connections == 0) return protocol::SceneCopies::none;
  return protocol::compareScenes(protocol::describedScene(own_text), protocol::describedScene(s.touchpad));
}

nlohmann::ordered_json endJson(const device::RobotRunnerStatus& s) {
  const protocol::RobotCounters& c = s.counters;
  const Vec3& position = s.readings.position_mm;
  return {{"robot", s.description},
          {"bind", protocol::toString(s.local)},
          {"phase", protocol::toString(s.phase)},
          {"seconds", jsonNumber(s.seconds)},
          {"prepared", s.prepared},
          {"probe", device::toString(s.probe_outcome)},
          {"stiffness_N_per_mm", jsonNumber(s.probed_stiffness_N_per_mm)},
          {"position_mm", {jsonNumber(position.x), jsonNumber(position.y), jsonNumber(position.z)}},
          {"force_N", jsonNumber(s.readings.force_N)},
          {"prediction_error_mm", jsonNumber(s.reference.error_mm)},
          {"prediction_horizon_ms", jsonNumber(s.reference.horizon_ms)},
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
          {"robot_resumed", s.robot_resumed},
          {"robot_problem", s.robot_problem},
          {"targets_refused", s.targets_refused},
          {"problem", s.problem}};
}

// Reports once what was probed, and the arm's problem when it begins, ends, or lasts long.
class Teller {
 public:
  Teller(std::string touchpad, std::string_view own_text) : touchpad_(std::move(touchpad)), own_text_(own_text) {}

  void tell(const device::RobotRunnerStatus& s) {
    const bool problem = !s.robot_problem.empty();
    if (problem && (!problem_ || Clock::now() - told_ >= kTellAgain)) {
      std::cerr << s.robot_problem.text() + "\n";
      told_ = Clock::now();
    } else if (!problem && problem_) {
      std::cerr << "the arm follows\n";
    }
    problem_ = problem;
    if (const auto scenes = scenesOf(s, own_text_); scenes != std::exchange(scenes_, scenes)) {
      std::cerr << fmt::format("{}: {}\n", touchpad_, protocol::toString(scenes));
    }
    if (!s.prepared || prepared_) return;
    prepared_ = true;
    std::cerr << fmt::format("{}: probe {}, {:.3f} N/mm; calling {} from {}\n", s.description,
                             device::toString(s.probe_outcome), s.probed_stiffness_N_per_mm, touchpad_,
                             protocol::toString(s.local));
  }

 private:
  std::string touchpad_;
  std::string_view own_text_;
  protocol::SceneCopies scenes_ = protocol::SceneCopies::none;
  bool problem_ = false;
  bool prepared_ = false;
  Instant told_{};
};

}  // namespace

void addEndOptions(CLI::App& command, EndOptions& options) {
  auto* link = command.add_flag("--link", options.link,
                                "Speak FYD Link (secured) in place of the classic protocol; needs --key");
  command.add_option("--key", options.key, "Key file of FYD Link");
  command.add_option("--state-rate", options.state_rate_Hz, "States a second to ask for over FYD Link")
      ->check(numberFrom(1.0, 1'000.0))
      ->needs(link)
      ->capture_default_str();
  command.add_option("--connect", options.connect, "Touchpad to call, HOST:PORT")->required();
  command.add_option("--bind", options.bind, "Own address, HOST:PORT; port 0: any")->capture_default_str();
  command
      .add_option("--rate", options.rate_Hz, "Cycles a second; each sends a state (classic) or a sample in one (link)")
      ->check(numberFrom(1.0, 10'000.0))
      ->capture_default_str();
  command.add_option("--command-at", options.commands,
                     "SECONDS:NAME, a command of the robot's operator that long after the first handshake; "
                     "repeatable. Names: " +
                         joined(kCommandNames));
  command.add_option("--motor-reference", options.motor_reference, "FIRST,SECOND ticks, sent after motor-reference-on");
  command
      .add_option("--waits", options.waits,
                  "For a reply: modern (100 ms, then on), wired (for ever) or wireless (1 s, twice), as the authors'")
      ->check(CLI::IsMember({"modern", "wired", "wireless"}))
      ->excludes(link)
      ->capture_default_str();
  addRunOptions(command, options.duration_s, options.json, "Ctrl-C or command disconnect");
}

device::RobotRunnerOptions runnerOptions(const EndOptions& given, std::string_view name) {
  device::RobotRunnerOptions options;
  options.touchpad = partnerOrUsageError("--connect", given.connect);
  options.bind = endpointOrUsageError("--bind", given.bind);
  requireOneFamily({"--bind", options.bind}, {"--connect", options.touchpad});
  options.rate_Hz = given.rate_Hz;
  const auto reference = numbersOrUsageError("--motor-reference", given.motor_reference, 2);
  options.motor_reference = {.first_ticks = reference[0], .second_ticks = reference[1]};
  if (given.waits == "wired") options.link = protocol::ClassicRobotSettings::wired();
  if (given.waits == "wireless") options.link = protocol::ClassicRobotSettings::wireless();
  if (given.link != !given.key.empty()) {
    throw UsageError(given.link ? say("--link: FYD Link needs --key FILE; fyd link keygen makes one")
                                : say("--key: only FYD Link takes a key; add --link"));
  }
  options.secure.rates.state_Hz = given.state_rate_Hz;
  options.secure.text = name;
  for (const std::string& text : given.commands) options.commands.push_back(parseCommandAt(text));
  if (given.link) options.key = valueOrFail(protocol::readKeyFile(given.key));
  return options;
}

void runRobotEnd(const EndOptions& given, const device::RobotRunnerOptions& options, std::unique_ptr<device::Robot> arm,
                 const std::function<nlohmann::ordered_json()>& arm_summary) {
  const auto robot = valueOrFail(device::RobotRunner::open(options, std::move(arm)));
  Teller teller(protocol::toString(options.touchpad), options.secure.text);
  teller.tell(robot->status());
  runUntilInterrupted([&](const std::stop_token& stop) { robot->run(stop, runLimit(given.duration_s)); },
                      [&] { teller.tell(robot->status()); });

  const device::RobotRunnerStatus status = robot->status();
  nlohmann::ordered_json summary = endJson(status);
  summary["scenes"] = protocol::kSceneCopies[static_cast<std::size_t>(scenesOf(status, options.secure.text))];
  if (arm_summary) summary["arm"] = arm_summary();
  printSummary(summary, given.json);
  if (!status.prepared || (status.connections == 0 && !status.robot_problem.empty())) {
    throw Failure(say("{}: the arm was not ready in {:.1f} s: {}", status.description, status.seconds,
                      status.robot_problem.empty() ? say("stopped before") : status.robot_problem));
  }
  if (status.connections == 0) {
    throw Failure(
        say("{}: {} in {:.1f} s", protocol::toString(options.touchpad), phrase(status.problem), status.seconds));
  }
}

}  // namespace fyd::cli
