#include "app/cli/sim/sim_network.h"

#include <algorithm>
#include <optional>

#include "app/cli/parts/process_options.h"
#include "core/sim/network/network_relay.h"

namespace fyd::cli {
namespace {

struct NetworkCliOptions {
  std::string listen;
  std::string forward;
  std::string profile;
  std::optional<double> delay_ms;
  std::optional<double> jitter_ms;
  std::optional<double> loss_percent;
  std::optional<double> reorder_percent;
  std::optional<double> reorder_by_ms;
  std::optional<double> duplicate_percent;
  std::optional<double> rate_bit_per_s;
  std::optional<double> queue_ms;
  std::uint64_t seed = 1;
  double duration_s = 0.0;
  bool json = false;
};

void takeOptions(const NetworkCliOptions& given, sim::NetworkProfile& path) {
  for (sim::NetworkSettings* direction : {&path.forward, &path.backward}) {
    const auto set = [](const std::optional<double>& from, double& to) { to = from.value_or(to); };
    set(given.delay_ms, direction->delay_ms);
    set(given.jitter_ms, direction->jitter_ms);
    set(given.loss_percent, direction->loss_percent);
    set(given.reorder_percent, direction->reorder_percent);
    set(given.reorder_by_ms, direction->reorder_by_ms);
    set(given.duplicate_percent, direction->duplicate_percent);
    set(given.rate_bit_per_s, direction->rate_bit_per_s);
    set(given.queue_ms, direction->queue_ms);
    if (auto good = sim::checkNetwork(*direction); !good) throw UsageError(good.error().message);
  }
}

sim::NetworkProfile makePath(const NetworkCliOptions& given) {
  sim::NetworkProfile path;
  takeOptions(given, path);  // judged before a file is opened
  if (std::ranges::find(sim::kNetworkProfiles, given.profile) != sim::kNetworkProfiles.end()) {
    path = valueOrFail(sim::networkProfile(given.profile));
  } else if (!given.profile.empty()) {
    if (!given.profile.ends_with(".csv")) {
      throw UsageError(say("--profile \"{}\": expected isdn, adsl, lan or a CSV file", given.profile));
    }
    if (given.delay_ms) throw UsageError(say("--delay: a recorded profile has its own"));
    path.forward.trace = valueOrFail(sim::readDelayTrace(given.profile));
    path.backward.trace = path.forward.trace;
  }
  takeOptions(given, path);
  path.forward.seed = 2 * given.seed;
  path.backward.seed = 2 * given.seed + 1;
  return path;
}

nlohmann::ordered_json directionJson(const sim::DirectionStatistics& s) {
  return {{"received", s.received},
          {"delivered", s.delivered},
          {"lost", s.lost},
          {"queue_full", s.queue_full},
          {"reordered", s.reordered},
          {"duplicated", s.duplicated},
          {"bytes", s.bytes},
          {"send_failures", s.send_failures},
          {"delay_ms_mean", jsonNumber(s.delay_ms_mean)},
          {"delay_ms_min", jsonNumber(s.delay_ms_min)},
          {"delay_ms_max", jsonNumber(s.delay_ms_max)},
          {"late_ms_max", jsonNumber(s.late_ms_max)}};
}

void runNetwork(const NetworkCliOptions& given) {
  sim::NetworkRelayOptions options;
  options.listen = endpointOrUsageError("--listen", given.listen);
  options.forward = partnerOrUsageError("--forward", given.forward);
  options.path = makePath(given);
  const auto relay = valueOrFail(sim::NetworkRelay::open(options));
  runUntilInterrupted([&](const std::stop_token& stop) { relay->run(stop, runLimit(given.duration_s)); });
  const sim::NetworkRelayStatus status = relay->status();
  printSummary({{"listen", protocol::toString(status.listen)},
                {"forward_to", protocol::toString(options.forward)},
                {"seconds", jsonNumber(status.seconds)},
                {"callers", status.callers},
                {"callers_refused", status.callers_refused},
                {"no_socket", status.no_socket.text()},
                {"wrong_peer_datagrams", status.wrong_peer},
                {"forward", directionJson(status.forward)},
                {"backward", directionJson(status.backward)}},
               given.json);
}

}  // namespace

void addSimNetwork(CLI::App& sim) {
  auto options = std::make_shared<NetworkCliOptions>();
  CLI::App* network = sim.add_subcommand("network", "A UDP relay that delays, loses, reorders and limits as a network");
  network->add_option("--listen", options->listen, "Own address, HOST:PORT, to be called in place of the other side")
      ->required();
  network->add_option("--forward", options->forward, "The other side, HOST:PORT")->required();
  network->add_option(
      "--profile", options->profile,
      "isdn, adsl, lan, or a CSV file with columns delay_ms or t_s,delay_ms; the following override it");
  network->add_option("--delay", options->delay_ms, "Milliseconds each way");
  network->add_option("--jitter", options->jitter_ms, "Standard deviation of the delay, ms");
  network->add_option("--loss", options->loss_percent, "Share of the datagrams lost, %");
  network->add_option("--reorder", options->reorder_percent, "Share of the datagrams held back for others, %");
  network->add_option("--reorder-by", options->reorder_by_ms, "How long those are held back, ms");
  network->add_option("--duplicate", options->duplicate_percent, "Share of the datagrams doubled, %");
  network->add_option("--rate", options->rate_bit_per_s, "Flow of the line, bit/s; 0: without limit");
  network->add_option("--queue", options->queue_ms, "Longest wait for the line, ms; what would wait longer is dropped");
  network->add_option("--seed", options->seed, "Seed of the random delays, losses and copies")
      ->transform(wholeNumberFrom(0, 1'000'000'000));
  addRunOptions(*network, options->duration_s, options->json, "Ctrl-C");
  network->callback([options] { runNetwork(*options); });
}

}  // namespace fyd::cli
