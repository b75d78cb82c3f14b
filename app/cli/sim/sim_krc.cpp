#include "app/cli/sim/sim_krc.h"

#include "app/cli/parts/process_options.h"
#include "core/sim/robot/krc.h"

namespace fyd::cli {
namespace {

struct KrcCliOptions {
  std::string remote;
  std::string bind = "127.0.0.3:0";
  double period_ms = 5.0;
  double monitor_for_s = 1.0;
  std::vector<std::string> modes;
  MaterialOptions material;
  double duration_s = 0.0;
  bool json = false;
};

sim::TimedMode parseModeAt(std::string_view text) {
  const std::size_t colon = text.find(':');
  for (const auto mode : {protocol::FriState::off, protocol::FriState::monitor, protocol::FriState::command}) {
    if (colon == std::string_view::npos || text.substr(colon + 1) != protocol::toString(mode)) continue;
    const double at_s = numberOrUsageError("--mode-at", text.substr(0, colon));
    if (at_s >= 0.0) return {.at_s = at_s, .mode = mode};
  }
  throw UsageError(say("--mode-at \"{}\": expected SECONDS:off, SECONDS:monitor or SECONDS:command", text));
}

nlohmann::ordered_json controllerJson(const sim::KrcStatus& s) {
  const sim::KrcCounters& c = s.counters;
  return {{"bind", protocol::toString(s.local)},
          {"mode", protocol::toString(s.mode)},
          {"quality", protocol::toString(s.quality)},
          {"seconds", jsonNumber(s.seconds)},
          {"measurements_sent", c.measurements},
          {"answers", c.answers},
          {"answer_rate", jsonNumber(s.answer_rate)},
          {"latency_ms", jsonNumber(s.latency_ms)},
          {"late_answers", c.late_answers},
          {"wrong_echoes", c.wrong_echoes},
          {"wrong_mirrors", c.wrong_mirrors},
          {"wrong_flags", c.wrong_flags},
          {"leaps", c.leaps},
          {"command_entries", c.command_entries},
          {"command_losses", c.command_losses},
          {"refused_datagrams", c.refused},
          {"wrong_peer_datagrams", c.wrong_peer},
          {"send_failures", c.send_failures},
          {"position_mm", {jsonNumber(s.position_mm.x), jsonNumber(s.position_mm.y), jsonNumber(s.position_mm.z)}},
          {"force_N", jsonNumber(s.force_N)},
          {"largest_force_N", jsonNumber(s.largest_force_N)},
          {"lowest_z_mm", jsonNumber(s.lowest_z_mm)},
          {"fastest_mm_s", jsonNumber(s.fastest_mm_s)},
          {"travelled_mm", jsonNumber(s.travelled_mm)},
          {"stiffness_N_per_m", jsonNumber(s.stiffness_N_per_m)},
          {"rotation_stiffness_Nm_per_rad", jsonNumber(s.rotation_stiffness_Nm_per_rad)},
          {"damping", jsonNumber(s.damping)}};
}

void runKrc(const KrcCliOptions& given) {
  sim::KrcOptions options;
  options.remote = partnerOrUsageError("--remote", given.remote);
  options.bind = endpointOrUsageError("--bind", given.bind);
  requireOneFamily({"--bind", options.bind}, {"--remote", options.remote});
  options.period_ms = given.period_ms;
  options.monitor_for_s = given.monitor_for_s;
  options.arm = simParameters(given.material);
  for (const std::string& text : given.modes) options.modes.push_back(parseModeAt(text));
  const auto krc = valueOrFail(sim::Krc::open(options));
  runUntilInterrupted([&](const std::stop_token& stop) { krc->run(stop, runLimit(given.duration_s)); });
  const sim::KrcStatus status = krc->status();
  printSummary(controllerJson(status), given.json);
  if (status.counters.answers == 0) {
    throw Failure(say("{}: no answer in {:.1f} s", given.remote, status.seconds));
  }
}

}  // namespace

void addSimKrc(CLI::App& sim) {
  auto options = std::make_shared<KrcCliOptions>();
  CLI::App* krc = sim.add_subcommand("krc", "The controller of a KUKA LWR, over FRI, with a simulated arm");
  krc->add_option("--remote", options->remote, "Robot end to send to, HOST:PORT (port 49938 on a real one)")
      ->required();
  krc->add_option("--bind", options->bind, "Own address, HOST:PORT; port 0: any")->capture_default_str();
  krc->add_option("--period", options->period_ms, "Milliseconds between two measurements")
      ->check(numberFrom(1.0, 100.0))
      ->capture_default_str();
  krc->add_option("--monitor-for", options->monitor_for_s, "Seconds of good link quality before command mode")
      ->check(numberFrom(0.0, 1e6))
      ->capture_default_str();
  krc->add_option("--mode-at", options->modes, "SECONDS:MODE, off, monitor or command from then on; repeatable");
  addMaterialOptions(*krc, options->material);
  addRunOptions(*krc, options->duration_s, options->json, "Ctrl-C");
  krc->callback([options] { runKrc(*options); });
}

}  // namespace fyd::cli
