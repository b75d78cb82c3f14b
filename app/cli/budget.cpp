// fyd budget: points, bits and message size for a workspace and a line [tele-gesture Eq. 1 and 2].
#include <array>
#include <charconv>
#include <iostream>

#include "app/cli/parts/command.h"
#include "core/protocol/link/message_budget.h"

namespace fyd::cli {
namespace {

struct BudgetOptions {
  std::string workspace;
  double precision_mm = 0.02;
  double flow_bit_per_s = 0.0;
  double period_ms = 0.0;
  bool json = false;
};

Vec3 parseWorkspace(const std::string& text) {
  const auto wrong = [&] {
    return UsageError(say("--workspace \"{}\": expected three lengths in mm such as 160x130x130", text));
  };
  std::array<double, 3> side{};
  const char* at = text.data();
  const char* end = at + text.size();
  for (std::size_t i = 0; i < side.size(); ++i) {
    if (i > 0 && (at == end || *at++ != 'x')) throw wrong();
    const auto [after, problem] = std::from_chars(at, end, side[i]);
    if (problem != std::errc()) throw wrong();
    at = after;
  }
  if (at != end) throw wrong();
  return {side[0], side[1], side[2]};
}

void runBudget(const BudgetOptions& options) {
  const protocol::TouchFields all{.force = true, .indentation = true, .orientation = true};
  const auto budget = protocol::messageBudget(parseWorkspace(options.workspace), options.precision_mm,
                                              options.flow_bit_per_s, options.period_ms, all);
  if (!budget) throw UsageError(say("budget: {}", budget.error().message));
  const nlohmann::ordered_json out{{"points_per_axis", budget->points_per_axis},
                                   {"bits_per_axis", budget->bits_per_axis},
                                   {"max_message_bits", jsonNumber(budget->max_message_bits)},
                                   {"message_bits", budget->message_bits},
                                   {"datagram_bits", budget->datagram_bits},
                                   {"force", budget->fields.force},
                                   {"indentation", budget->fields.indentation},
                                   {"orientation", budget->fields.orientation},
                                   {"fits", budget->fits}};
  printValues(out, options.json);
}

}  // namespace

void add_budget(CLI::App& app) {
  auto options = std::make_shared<BudgetOptions>();
  CLI::App* command = app.add_subcommand("budget", "How many bits a position needs and how large a message may be");
  command->add_option("--workspace", options->workspace, "Sides in mm, such as 160x130x130")->required();
  command->add_option("--precision", options->precision_mm, "mm")->capture_default_str();
  command->add_option("--flow", options->flow_bit_per_s, "Flow of the line, bit/s")->required();
  command->add_option("--period", options->period_ms, "Between two messages, ms")->required();
  command->add_flag("--json", options->json, "Result as JSON");
  command->callback([options] { runBudget(*options); });
}

}  // namespace fyd::cli
