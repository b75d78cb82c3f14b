// Records the golden recordings of tests/data/recordings: short sessions of the station on its simulated touchpad, one
// for each way of working that a recording must outlive. Run by hand only; see tests/data/recordings/README.md. But
// `staircase`, whose touch says how its cloth answers, is too long to be kept: Python's tests record it when they run.
//
//   record_golden FOLDER SCENE SURFACE.toml    writes FOLDER/SCENE.h5 and the profile FOLDER/SCENE.toml
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <functional>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "core/device/robot/robot_runner.h"
#include "core/protocol/link/link_key_file.h"
#include "core/sim/robot/robot_arm.h"
#include "core/station/station.h"
#include "tests/child_process.h"

namespace {

using namespace fyd;
using pipeline::OperatorAction;
using pipeline::SafetyState;

constexpr Duration kPatience = std::chrono::seconds(20);

struct Act {
  double at_s = 0.0;  // after the recording's start
  std::function<void(station::Station&)> what;
};

struct Scene {
  std::vector<std::pair<std::string, std::string>> settings;
  std::string robot = "simulated";
  std::string surface;
  std::vector<Act> acts;
  double silent_from_s = 1e9;  // the window says nothing between these
  double silent_to_s = 1e9;
  std::vector<SafetyState> states;  // that the session must pass through, in this order
  bool from_the_start = false;
  bool real_time = true;
  double duration_s = 1.2;
};

Act command(double at_s, OperatorAction action, double value = 0.0) {
  return {at_s, [=](station::Station& s) { (void)s.command({.action = action, .value = value}); }};
}
Act set(double at_s, const std::string& id, double value) {
  return {at_s, [=](station::Station& s) {
            if (const auto done = s.setParameter(id, value); !done) throw std::runtime_error(done.error().text());
          }};
}
Act note(double at_s, recording::NoteKind kind, const std::string& text) {
  return {at_s, [=](station::Station& s) { (void)s.note(kind, text); }};
}

/// A finger that stays, on a cloth whose target goes up and down: the stretch moves, and the stiffness is read all along.
Scene staircase() {
  constexpr double kStep_s = 1.2;
  Scene out{.states = {SafetyState::active}, .real_time = false, .duration_s = 6.0 * kStep_s};
  out.acts.push_back({0.0, [](station::Station& s) { s.moveSimulatedFinger(0.0, 0.0, 6.0); }});
  double at_s = 0.0;
  for (const double target_N_per_mm : {0.62, 0.80, 0.66, 0.75, 0.62, 0.80}) {  // what 6 mm in the middle can do
    out.acts.push_back(command(at_s, OperatorAction::target_by_hand, target_N_per_mm));
    at_s += kStep_s;
  }
  return out;
}

std::map<std::string, Scene> scenes(const std::string& surface) {
  std::map<std::string, Scene> out;
  out["classic"] = {.states = {SafetyState::active}};
  out["link"] = {.robot = "link:127.0.0.1:0", .states = {SafetyState::active}};
  out["thesis"] = {.settings = {{"sensing.finger_mode", "thesis"},
                                {"sensing.indentation_mode", "thesis"},
                                {"sensing.stiffness_mode", "thesis"},
                                {"control.mode", "thesis"},
                                {"control.law", "thesis"},
                                {"texture.filter", "thesis"},
                                {"texture.pwm", "thesis"},
                                {"texture.method", "dft321_thesis"}},
                   .states = {SafetyState::active}};
  out["changes"] = {
      .acts = {set(0.1, "control.kp", 20.0), set(0.2, "texture.k_vib", 1.7), set(0.3, "texture.dead_zone_percent", 5.0),
               command(0.4, OperatorAction::target_by_hand, 0.55), set(0.5, "pipeline.hand_target_N_per_mm", 0.68),
               set(0.6, "texture.method", 1.0), note(0.7, recording::NoteKind::note, "softer now"),
               set(0.8, "control.ki", 8.0), command(0.9, OperatorAction::target_from_robot),
               note(1.0, recording::NoteKind::bookmark, "")},
      .states = {SafetyState::active}};
  out["held"] = {.acts = {command(1.0, OperatorAction::arm),
                          {1.2, [](station::Station& s) { s.requestStop(); }},
                          command(1.4, OperatorAction::arm)},
                 .silent_from_s = 0.2,
                 .silent_to_s = 0.85,
                 .states = {SafetyState::active, SafetyState::held, SafetyState::active, SafetyState::stopped,
                            SafetyState::active},
                 .duration_s = 1.8};
  out["tare"] = {.acts = {{0.1, [](station::Station& s) { s.moveSimulatedFinger(0.0, 0.0, 0.0); }},
                          command(0.4, OperatorAction::tare),
                          {1.6, [](station::Station& s) { s.releaseSimulatedFinger(); }}},
                 .states = {SafetyState::active},
                 .from_the_start = true,
                 .duration_s = 2.2};
  out["surface"] = {.robot = "none", .surface = surface, .states = {SafetyState::active}};
  out["vibration"] = {.settings = {{"texture.dead_zone_percent", "0"}, {"texture.k_vib", "10"}},
                      .acts = {set(0.5, "texture.method", 1.0), set(0.9, "texture.k_vib", 4.0)},
                      .states = {SafetyState::active}};
  out["frame512"] = {.settings = {{"texture.frame", "512"}}, .states = {SafetyState::active}};
  out["crashed"] = {.states = {SafetyState::active}};
  out["staircase"] = staircase();
  return out;
}

[[noreturn]] void giveUp(const std::string& why) {
  fmt::print(stderr, "record_golden: {}\n", why);
  std::exit(1);
}

/// @return why the session is not the one wanted; empty: it is
std::string record(const std::string& folder, const std::string& name, const Scene& scene) {
  const std::string key_file = folder + "/golden.key";
  station::StationOptions options{
      .touchpad = "simulated", .robot = scene.robot, .surface = scene.surface, .real_time = scene.real_time};
  station::Profile& profile = options.profile;
  const std::vector<Parameter> bound = bindParameters(profile);
  std::vector<std::pair<std::string, std::string>> settings = scene.settings;
  // Small files: few pictures, and such as compress well.
  settings.insert(settings.end(), {{"session.pre_trigger_s", "0"},
                                   {"session.whole_pictures_Hz", "0.1"},
                                   {"sim.camera_rate_Hz", "10"},
                                   {"sim.camera_noise", "0"}});
  for (const auto& [id, value] : settings) {
    const Parameter* parameter = findParameter(bound, id);
    if (parameter == nullptr) giveUp(id + ": no such parameter");
    if (const auto done = assignParameter(*parameter, value); !done) giveUp(done.error().text());
  }
  const auto key = protocol::LinkKey::generate();
  const bool link = scene.robot.starts_with("link:");
  if (link) {
    ::unlink(key_file.c_str());
    if (const auto written = protocol::writeKeyFile(key, key_file); !written) giveUp(written.error().text());
    options.key_file = key_file;
  }
  auto opened = station::Station::open(options);
  if (!opened) giveUp(opened.error().text());
  station::Station& station = **opened;
  station.start();
  std::unique_ptr<device::RobotRunner> arm;
  std::jthread arm_thread;
  if (link) {
    device::RobotRunnerOptions robot;
    robot.touchpad = *protocol::parseEndpoint(station.status().link.local);
    robot.bind = *protocol::parseEndpoint("127.0.0.2:0");
    robot.key = key;
    arm = std::move(*device::RobotRunner::open(robot, std::make_unique<sim::RobotArm>(profile.sim)));
    arm_thread = std::jthread([&arm](const std::stop_token& stop) { arm->run(stop); });
  }
  if (scene.robot == "none") {
    (void)station.command({.action = OperatorAction::target_by_hand, .value = 0.6});
  }

  std::vector<SafetyState> states;
  pipeline::SafetyState state = SafetyState::disconnected;
  const Instant opened_at = Clock::now();
  std::optional<Instant> started;
  bool armed = false;
  std::size_t next = 0;
  std::vector<pipeline::TelemetrySample> samples(1024);
  for (;;) {
    const Instant now = Clock::now();
    for (const station::Notice& notice : station.takeNotices()) {
      if (notice.event.kind != pipeline::EventKind::state_changed) continue;
      state = notice.event.state;
      if (started) states.push_back(state);
    }
    while (station.takeTelemetry(samples) > 0) {
    }
    if (!armed && state == SafetyState::ready) {
      (void)station.command({.action = OperatorAction::arm});
      armed = true;
    }
    if (!started && (scene.from_the_start || state == SafetyState::active)) {
      if (const auto begun = station.startRecording({.path = fmt::format("{}/{}.h5", folder, name),
                                                     .operator_name = "Golden",
                                                     .subject = "S00",
                                                     .notes = "Golden recording: " + name,
                                                     .tags = {"golden"}});
          !begun) {
        giveUp(begun.error().text());
      }
      started = now;
      states.push_back(state);
    }
    if (started) {
      const double into_s = toSeconds(now - *started);
      if (into_s >= scene.duration_s) break;
      for (; next < scene.acts.size() && into_s >= scene.acts[next].at_s; ++next) scene.acts[next].what(station);
      if (into_s < scene.silent_from_s || into_s > scene.silent_to_s) station.windowAlive();
    }
    if (now - opened_at > kPatience) giveUp("the session is not Active after 20 s");
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  if (const auto closed = station.stopRecording(); !closed) giveUp(closed.error().text());
  if (const auto kept = station::saveProfile(station.currentProfile(), folder + "/" + name + ".toml"); !kept) {
    giveUp(kept.error().text());
  }
  arm_thread = {};
  station.shutDown();
  ::unlink(key_file.c_str());
  std::vector<SafetyState> passed;
  for (const SafetyState each : states) {
    if (scene.from_the_start && each != SafetyState::active) continue;
    if (passed.empty() || passed.back() != each) passed.push_back(each);
  }
  if (passed != scene.states) return fmt::format("passed through {} states, not as wanted", passed.size());
  return {};
}

void recordAndDie(const std::string& folder, const std::string& name, const Scene& scene) {
  const ChildProcess child([&] {
    Scene longer = scene;
    longer.duration_s = 60.0;
    (void)record(folder, name, longer);
    return 1;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(3200));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) giveUp("usage: record_golden FOLDER SCENE SURFACE.toml");
  const std::string folder = argv[1];
  const std::string name = argv[2];
  const auto all = scenes(argv[3]);
  const auto scene = all.find(name);
  if (scene == all.end()) giveUp("no scene " + name);
  const std::string file = folder + "/" + name + ".h5";
  if (name == "crashed") {
    recordAndDie(folder, name, scene->second);
    return 0;
  }
  for (int tries = 0; tries < 20; ++tries) {  // a busy machine may lead to Held, which is not what is wanted here
    ::unlink(file.c_str());
    const std::string why = record(folder, name, scene->second);
    if (why.empty()) return 0;
    fmt::print(stderr, "record_golden: {}: {}; again\n", name, why);
  }
  giveUp("no try succeeded");
}
