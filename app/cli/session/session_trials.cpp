// fyd session trials: an experiment's trials in a random, balanced order.
#include <iostream>

#include "app/cli/session/session_cli.h"
#include "core/experiment/trials.h"

namespace fyd::cli {

void addSessionTrials(CLI::App& parent) {
  struct Options {
    std::vector<std::string> conditions;
    std::size_t repetitions = 1;
    std::uint64_t seed = 1;
    bool latin_square = false;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      parent.add_subcommand("trials", "Trials in a random, balanced order; the same seed, the same order");
  addWords(*command, "--conditions", options->conditions, "Names, separated by commas")->required();
  command->add_option("--repetitions", options->repetitions, "How often each condition comes")
      ->transform(wholeNumberFrom(1, experiment::kMaximumRepetitions));
  command->add_option("--seed", options->seed, "Gives the same order again")->transform(wholeNumberFrom(0));
  command->add_flag("--latin-square", options->latin_square,
                    "Rows of a Williams design instead of shuffled blocks: balanced for what came just before");
  command->add_flag("--json", options->json, "As JSON");
  command->callback([options] {
    const auto order =
        options->latin_square ? experiment::TrialOrder::latin_square : experiment::TrialOrder::permuted_blocks;
    const auto trials = experiment::orderTrials(options->conditions, options->repetitions, options->seed, order);
    if (!trials) throw UsageError(say("session trials: {}", trials.error().message));
    auto json = nlohmann::ordered_json::array();
    for (const experiment::Trial& trial : *trials) {
      json.push_back({{"number", trial.number}, {"block", trial.block}, {"condition", trial.condition}});
      if (!options->json) std::cout << fmt::format("{:>4}  {:>4}  {}\n", trial.number, trial.block, trial.condition);
    }
    if (options->json) printJson(json);
  });
}

}  // namespace fyd::cli
