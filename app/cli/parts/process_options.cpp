#include "app/cli/parts/process_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <thread>

#include "core/base/end_signals.h"

namespace fyd::cli {
protocol::Endpoint endpointOrUsageError(const std::string& option, const std::string& text) {
  auto endpoint = protocol::parseEndpoint(text);
  if (!endpoint) throw UsageError(about(option, endpoint.error().message));
  return *endpoint;
}

protocol::Endpoint partnerOrUsageError(const std::string& option, const std::string& text) {
  const protocol::Endpoint partner = endpointOrUsageError(option, text);
  if (partner.port == 0) throw UsageError(say("{} {}: no port to send to; expected HOST:PORT", option, text));
  return partner;
}

void requireOneFamily(const GivenEndpoint& own, const GivenEndpoint& partner) {
  if (own.endpoint.v6 == partner.endpoint.v6) return;
  throw UsageError(say("{} {} cannot send to {} {}: both must be IPv4 or both IPv6", own.option,
                       protocol::toString(own.endpoint), partner.option, protocol::toString(partner.endpoint)));
}

double numberOrUsageError(const std::string& option, std::string_view text) {
  double value = 0.0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || problem != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    throw UsageError(say("{}: \"{}\" is not a number", option, text));
  }
  return value;
}

std::vector<double> numbersOrUsageError(const std::string& option, std::string_view text, std::size_t count) {
  std::vector<double> numbers;
  for (std::string_view rest = text;;) {
    const std::size_t comma = rest.find(',');
    numbers.push_back(numberOrUsageError(option, rest.substr(0, comma)));
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  if (numbers.size() != count) {
    throw UsageError(say("{} \"{}\": expected {} numbers separated by commas", option, text, count));
  }
  return numbers;
}

void addMaterialOptions(CLI::App& command, MaterialOptions& options) {
  command.add_option("--material", options.material, "What lies under the simulated tool")
      ->check(CLI::IsMember(std::vector<std::string>(sim::kMaterialNames.begin(), sim::kMaterialNames.end())))
      ->capture_default_str();
  command.add_option("--stiffness", options.stiffness, "N/mm in place of the material's own; 0 keeps that")
      ->check(numberFrom(0.0, 1000.0));
  command.add_option("--seed", options.seed, "Seed of the simulation's noise")
      ->transform(wholeNumberFrom(0, 1'000'000'000));
}

sim::SimParameters simParameters(const MaterialOptions& options) {
  sim::SimParameters parameters;
  parameters.seed = options.seed;
  parameters.material_stiffness_N_per_mm = options.stiffness;
  parameters.material = static_cast<sim::Material>(std::ranges::find(sim::kMaterialNames, options.material) -
                                                   sim::kMaterialNames.begin());
  return parameters;
}

void addRunOptions(CLI::App& command, double& duration_s, bool& json, const std::string& until) {
  command.add_option("--duration", duration_s, "Seconds to run; 0: until " + until)->check(numberFrom(0.0, 1e9));
  command.add_flag("--json", json, "Summary as JSON");
}

void runUntilInterrupted(const std::function<void(const std::stop_token&)>& run, const std::function<void()>& look) {
  watchForEnd();
  std::stop_source source;
  // Its destructor ends it, also when `run` throws.
  const std::jthread watcher([&](const std::stop_token& over) {
    while (!over.stop_requested() && endSignal() == 0) {
      if (look) look();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    source.request_stop();
  });
  run(source.get_token());
}

Duration runLimit(double duration_s) { return duration_s > 0.0 ? fromSeconds(duration_s) : Duration::max(); }

void printSummary(const nlohmann::ordered_json& summary, bool json) { printValues(summary, json); }

}  // namespace fyd::cli
