// Shared by subcommands that run as the partner of another process: addresses, numbers, the material under a simulated
// tool, running until Ctrl-C, the summary at the end.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/parts/command.h"
#include "core/base/time.h"
#include "core/protocol/endpoint.h"
#include "core/sim/sim_parameters.h"

namespace fyd::cli {

[[nodiscard]] protocol::Endpoint endpointOrUsageError(const std::string& option, const std::string& text);
/// The same for an address to send to: one without a port cannot be.
[[nodiscard]] protocol::Endpoint partnerOrUsageError(const std::string& option, const std::string& text);
/// An address and the option that it was given by.
struct GivenEndpoint {
  std::string_view option;
  protocol::Endpoint endpoint;
};
/// UsageError when one is of IPv4 and the other of IPv6: the one cannot send to the other.
void requireOneFamily(const GivenEndpoint& own, const GivenEndpoint& partner);
/// Exactly `count` finite numbers, separated by commas.
[[nodiscard]] std::vector<double> numbersOrUsageError(const std::string& option, std::string_view text,
                                                      std::size_t count);
[[nodiscard]] double numberOrUsageError(const std::string& option, std::string_view text);

struct MaterialOptions {
  std::string material = "rubber";
  double stiffness = 0.0;
  int seed = 1;
};
void addMaterialOptions(CLI::App& command, MaterialOptions& options);
[[nodiscard]] sim::SimParameters simParameters(const MaterialOptions& options);

void addRunOptions(CLI::App& command, double& duration_s, bool& json, const std::string& until);

/// Calls `run` with a token that Ctrl-C or the termination signal stops; meanwhile calls `look`, if any, every
/// 20 ms from another thread.
void runUntilInterrupted(const std::function<void(const std::stop_token&)>& run,
                         const std::function<void()>& look = {});
/// Seconds as a limit: 0 is none.
[[nodiscard]] Duration runLimit(double duration_s);

/// As JSON, or one line for each key; a nested object's lines carry both keys.
void printSummary(const nlohmann::ordered_json& summary, bool json);

}  // namespace fyd::cli
