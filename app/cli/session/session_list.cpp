// fyd session list: the catalogue, or the recordings of one folder, searched and as a table.
#include <filesystem>
#include <iostream>

#include "app/cli/parts/terminal_text.h"
#include "app/cli/session/session_catalogue.h"
#include "app/cli/session/session_cli.h"
#include "core/catalogue/catalogue_rebuild.h"
#include "core/catalogue/catalogue_text.h"

namespace fyd::cli {
namespace {

using catalogue::SessionFilter;
using catalogue::SessionOrder;

struct SessionListOptions {
  std::string folder;
  std::string catalogue;
  SessionFilter filter;
  bool ascending = false;
  bool check = false;
  bool rebuild = false;
  bool json = false;
};

/// A folder's recordings in a catalogue of their own, in memory: the same search, nothing written.
catalogue::Catalogue catalogueOfFolder(const std::string& folder, catalogue::ScanReport& report) {
  auto catalogue = valueOrFail(catalogue::Catalogue::inMemory());
  report = valueOrFail(catalogue.addFolder(folder));
  return catalogue;
}

void runRebuild(const SessionListOptions& options) {
  std::vector<std::string> folders;
  if (!options.folder.empty()) folders.push_back(options.folder);
  const auto report = valueOrFail(catalogue::rebuildCatalogue(options.catalogue, folders));
  if (options.json) {
    printJson({{"moved_aside", report.moved_aside},
               {"rescued", report.rescued},
               {"folders", report.folders},
               {"scan", toJson(report.scan)}});
  } else {
    if (!report.moved_aside.empty()) {
      std::cout << fmt::format("damaged catalogue moved to {}; {} entries taken over from it\n", report.moved_aside,
                               report.rescued);
    }
    for (const std::string& folder : report.folders) std::cout << fmt::format("read again: {}\n", folder);
    printScan(report.scan);
  }
  failUnread(report.scan);
}

void runSessionList(const SessionListOptions& options) {
  if (options.rebuild) {
    runRebuild(options);
    return;
  }
  if (!options.folder.empty() && !options.catalogue.empty()) {
    throw UsageError(say("session list: a FOLDER or --catalogue, not both (`fyd session add FOLDER` puts one in)"));
  }
  if (!options.folder.empty() && options.check)
    throw UsageError(say("session list: --check is for a catalogue, not for a FOLDER"));
  valueOrUsage(catalogue::checkFilter(options.filter));
  catalogue::ScanReport scan;
  catalogue::Catalogue catalogue = options.folder.empty() ? openCatalogue(options.catalogue, AbsentCatalogue::refused)
                                                          : catalogueOfFolder(options.folder, scan);
  auto changes = nlohmann::ordered_json::array();
  if (options.check) {
    for (const catalogue::FileChange& change : valueOrFail(catalogue.checkFiles())) {
      changes.push_back({{"id", change.id},
                         {"change", catalogue::toString(change.kind)},
                         {"old_path", change.old_path},
                         {"new_path", change.new_path},
                         {"problem", change.problem}});
      if (options.json) continue;
      std::cout << fmt::format("{:<10} {}{}\n", catalogue::toString(change.kind), change.old_path,
                               change.new_path.empty() ? "" : " -> " + change.new_path);
      if (!change.problem.empty()) std::cout << forTerminal(fmt::format("not read: {}\n", change.problem));
    }
  }
  SessionFilter filter = options.filter;
  filter.descending = !options.ascending;
  const auto found = valueOrFail(catalogue.search(filter));
  const std::size_t all = valueOrFail(catalogue.count(filter));
  if (options.json) {
    nlohmann::ordered_json sessions = nlohmann::ordered_json::array();
    for (const catalogue::CatalogueEntry& entry : found) sessions.push_back(toJson(entry));
    printJson({{"catalogue", options.folder.empty() ? catalogue.name() : options.folder},
               {"found", all},
               {"changes", changes},
               {"copies", scan.copies},
               {"unreadable", scan.unreadable},
               {"sessions", sessions}});
  } else {
    printEntries(found);
    std::cout << fmt::format("{} of {} sessions\n", found.size(), all);
    printLeftOut(scan);
  }
  failUnread(scan);
}

}  // namespace

void addSessionList(CLI::App& session) {
  const auto options = std::make_shared<SessionListOptions>();
  CLI::App* command = session.add_subcommand("list", "Search the catalogue, or the recordings of a folder");
  command->add_option("folder", options->folder, "Read this folder instead of the catalogue; writes nothing");
  addCatalogueOption(*command, options->catalogue);
  SessionFilter& filter = options->filter;
  const std::size_t other = command->get_options().size();
  command->add_option("--text", filter.text, "Every word, in operator, subject, notes or a tag; case does not matter");
  command->add_option("--tag", filter.tags, "With this tag; repeatable: all of them")->allow_extra_args(false);
  command->add_option("--since", filter.since, "Started at this UTC time or later: 2026-11-21, 2026-11-21T14:05");
  command->add_option("--until", filter.until, "Started before this day, minute or second was over");
  command->add_option("--operator", filter.operator_name, "Exactly this operator");
  command->add_option("--subject", filter.subject, "Exactly this subject's code");
  command->add_option("--station", filter.station, "Put in by this host");
  command->add_option("--health", filter.health, "Of this health")
      ->check(CLI::IsMember({"good", "gaps", "growing", "damaged"}));
  const std::map<std::string, SessionOrder> orders = {{"started", SessionOrder::started},
                                                      {"duration", SessionOrder::duration},
                                                      {"operator", SessionOrder::operator_name},
                                                      {"subject", SessionOrder::subject},
                                                      {"bytes", SessionOrder::bytes},
                                                      {"path", SessionOrder::path}};
  command->add_option("--sort", filter.order, "started (default), duration, operator, subject, bytes or path")
      ->transform(CLI::Transformer(orders).description(""))
      ->transform(CLI::IsMember(orders).description(""));  // first: the other would name the values of the enum
  command->add_flag("--ascending", options->ascending, "Smallest first; without it the newest or largest");
  command->add_option("--limit", filter.limit, "At most so many; 0: all")->transform(wholeNumberFrom(0));
  command->add_option("--offset", filter.offset, "Leave out so many first")->transform(wholeNumberFrom(0));
  command->add_flag("--check", options->check, "First look where this station's files are now");
  const std::vector<CLI::Option*> so_far = command->get_options();
  CLI::Option* rebuild =
      command->add_flag("--rebuild", options->rebuild,
                        "Read all known folders, and FOLDER, again; a damaged catalogue is moved aside first");
  for (std::size_t i = other; i < so_far.size(); ++i) rebuild->excludes(so_far[i]);  // it searches nothing
  command->add_flag("--json", options->json, "Result as JSON");
  command->callback([options] { runSessionList(*options); });
  addSessionCatalogue(session);
}

}  // namespace fyd::cli
