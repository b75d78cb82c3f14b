// fyd session verify | recover FILE: is a recording whole, and making it so.
#include "app/cli/session/session_cli.h"
#include "core/catalogue/catalogue_types.h"
#include "core/recording/reader/recording_health.h"
#include "core/recording/recovery/recover.h"
#include "core/recording/recovery/verify.h"

namespace fyd::cli {
namespace {

std::string_view toString(recording::RecoverResult result) {
  switch (result) {
    case recording::RecoverResult::whole: return "whole";
    case recording::RecoverResult::part_lost: return "part lost";
    case recording::RecoverResult::nothing: return "nothing";
  }
  return "unknown";
}

}  // namespace

void addSessionVerify(CLI::App& parent) {
  auto options = std::make_shared<SessionOptions>();
  CLI::App* command =
      parent.add_subcommand("verify", "Check every commit and block of a recording; exit code 1 when one is damaged");
  addSessionOptions(*command, *options);
  command->callback([options] {
    const auto checked = valueOrFail(recording::verify(options->file));
    printValues({{"intact", checked.intact()},
                 {"wholeness", catalogue::toString(checked.wholeness)},
                 {"health", checked.health.word},
                 {"health_reason", checked.health.reason},
                 {"commits", checked.commits},
                 {"damaged_commits", checked.damaged_commits},
                 {"unproven_rows", checked.unproven_rows},
                 {"missing_bytes", checked.missing_bytes},
                 {"blocks", checked.blocks},
                 {"bytes", checked.bytes},
                 {"damaged", checked.damaged},
                 {"first_damage", checked.first_damage}},
                options->json);
    if (!checked.intact()) {
      throw Failure(say("{}: damaged: {} of {} commits, {} of {} blocks, {} rows are unproven; the first: {}",
                        options->file, checked.damaged_commits, checked.commits, checked.damaged, checked.blocks,
                        checked.unproven_rows, checked.first_damage));
    }
  });
}

void addSessionRecover(CLI::App& parent) {
  auto options = std::make_shared<SessionOptions>();
  CLI::App* command = parent.add_subcommand(
      "recover", "Make a recording whole after a crash; exit code 0: whole, 3: a part is lost, 1: nothing is left");
  addSessionOptions(*command, *options);
  command->callback([options] {
    const auto outcome = valueOrFail(recording::recover(options->file));
    if (outcome.result == recording::RecoverResult::nothing) {
      throw Failure(
          say("{}: nothing can be read; the file was left as it is: {}", options->file, outcome.first_damage));
    }
    auto missing = nlohmann::ordered_json::array();
    for (const recording::MissingRows& rows : outcome.missing) missing.push_back(recording::wordsOf(rows));
    printValues({{"result", toString(outcome.result)},
                 {"file", outcome.file},
                 {"kept", outcome.kept},
                 {"samples", outcome.steps},
                 {"lost_samples", outcome.lost_steps},
                 {"missing", missing},
                 {"first_damage", outcome.first_damage}},
                options->json);
    if (outcome.result == recording::RecoverResult::part_lost) {
      throw Failure(say("{}: a part is lost ({} steps; {}); what can be read is saved in {}, the original is {}",
                        options->file, outcome.lost_steps,
                        outcome.missing.empty() ? outcome.first_damage : recording::wordsOf(outcome.missing.front()),
                        outcome.file, outcome.kept),
                    3);
    }
  });
}

}  // namespace fyd::cli
