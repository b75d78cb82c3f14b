// fyd session verify | recover FILE: is a recording whole, and making it so.
#include "app/cli/exit_code.h"
#include "app/cli/session_cli.h"
#include "core/session/catalogue_types.h"
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
      parent.add_subcommand("verify", "Check every block of a recording; exit code 1 when one is damaged");
  addSessionOptions(*command, *options);
  command->callback([options] {
    const auto checked = valueOrFail(session::verify(options->file));
    printSession({{"intact", checked.intact()},
                  {"wholeness", session::toString(checked.wholeness)},
                  {"commits", checked.commits},
                  {"blocks", checked.blocks},
                  {"bytes", checked.bytes},
                  {"damaged", checked.damaged},
                  {"first_damage", checked.first_damage}},
                 options->json);
    if (!checked.intact()) {
      throw Failure(fmt::format("{}: {} of {} blocks are damaged, the first: {}", options->file, checked.damaged,
                                checked.blocks, checked.first_damage));
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
          fmt::format("{}: nothing can be read; the file was left as it is: {}", options->file, outcome.first_damage));
    }
    printSession({{"result", toString(outcome.result)},
                  {"file", outcome.file},
                  {"kept", outcome.kept},
                  {"samples", outcome.steps},
                  {"lost_samples", outcome.lost_steps},
                  {"first_damage", outcome.first_damage}},
                 options->json);
    if (outcome.result == session::RecoverResult::part_lost) {
      throw ExitCode(
          3, fmt::format("{}: a part is lost ({} steps; {}); what can be read is saved in {}, the original is {}",
                         options->file, outcome.lost_steps, outcome.first_damage, outcome.file, outcome.kept));
    }
  });
}

}  // namespace fyd::cli
