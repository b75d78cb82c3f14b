// fyd session verify | recover FILE: is a recording whole, and making it so.
#include "app/cli/session_cli.h"
#include "core/session/catalogue_types.h"
#include "core/session/recording_health.h"
#include "core/session/recover.h"
#include "core/session/verify.h"

namespace fyd::cli {
namespace {

std::string_view toString(session::RecoverResult result) {
  switch (result) {
    case session::RecoverResult::whole: return "whole";
    case session::RecoverResult::part_lost: return "part lost";
    case session::RecoverResult::nothing: return "nothing";
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
    const auto checked = valueOrFail(session::verify(options->file));
    printValues({{"intact", checked.intact()},
                 {"wholeness", session::toString(checked.wholeness)},
                 {"health", checked.health.word},
                 {"health_reason", checked.health.reason},
                 {"commits", checked.commits},
                 {"damaged_commits", checked.damaged_commits},
                 {"unproven_rows", checked.unproven_rows},
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
    const auto outcome = valueOrFail(session::recover(options->file));
    if (outcome.result == session::RecoverResult::nothing) {
      throw Failure(
          say("{}: nothing can be read; the file was left as it is: {}", options->file, outcome.first_damage));
    }
    auto missing = nlohmann::ordered_json::array();
    for (const session::MissingRows& rows : outcome.missing) missing.push_back(session::wordsOf(rows));
    printValues({{"result", toString(outcome.result)},
                 {"file", outcome.file},
                 {"kept", outcome.kept},
                 {"samples", outcome.steps},
                 {"lost_samples", outcome.lost_steps},
                 {"missing", missing},
                 {"first_damage", outcome.first_damage}},
                options->json);
    if (outcome.result == session::RecoverResult::part_lost) {
      throw Failure(say("{}: a part is lost ({} steps; {}); what can be read is saved in {}, the original is {}",
                        options->file, outcome.lost_steps,
                        outcome.missing.empty() ? outcome.first_damage : session::wordsOf(outcome.missing.front()),
                        outcome.file, outcome.kept),
                    3);
    }
  });
}

}  // namespace fyd::cli
