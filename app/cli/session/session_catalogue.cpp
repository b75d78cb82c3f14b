// fyd session add | store | tag | notes | forget: what changes the catalogue. No recording is changed by these;
// `store` moves one.
#include "app/cli/session/session_catalogue.h"

#include <filesystem>
#include <iostream>
#include <set>

#include "app/cli/parts/terminal_text.h"
#include "core/catalogue/archive_move.h"
#include "core/catalogue/catalogue_address.h"
#include "core/catalogue/catalogue_text.h"

namespace fyd::cli {
namespace {

struct SessionCatalogueOptions {
  std::string catalogue;
  std::vector<std::string> paths;
  std::string file;    ///< store: the recording
  std::string target;  ///< store: a folder; tag, notes, forget: id or recording
  std::string notes;
  std::vector<std::string> add, remove;
  bool json = false;
};

/// By id, its first digits, or the recording's file.
catalogue::CatalogueEntry entryFor(const catalogue::Catalogue& catalogue, const std::string& target) {
  std::error_code error;
  const bool is_file = target.find('/') != std::string::npos || std::filesystem::is_regular_file(target, error);
  return valueOrFail(catalogue.get(is_file ? valueOrFail(catalogue::readCatalogueEntry(target)).id : target));
}

void runAdd(const SessionCatalogueOptions& options) {
  catalogue::Catalogue catalogue = openCatalogue(options.catalogue, AbsentCatalogue::made);
  catalogue::ScanReport report;
  for (const std::string& path : options.paths) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
      const auto scan = valueOrFail(catalogue.addFolder(path));
      report.added += scan.added;
      report.known += scan.known;
      report.copies.insert(report.copies.end(), scan.copies.begin(), scan.copies.end());
      report.unreadable.insert(report.unreadable.end(), scan.unreadable.begin(), scan.unreadable.end());
      continue;
    }
    const auto entry = catalogue::readCatalogueEntry(path);
    if (!entry) {
      report.unreadable.push_back(entry.error().message);
      continue;
    }
    const bool known = !valueOrFail(catalogue.search({.id = entry->id})).empty();
    ++(known ? report.known : report.added);
    valueOrFail(catalogue.addAsOwn(*entry));
  }
  if (options.json) {
    printJson(toJson(report));
  } else {
    printScan(report);
  }
  failUnread(report);
}

void runStore(const SessionCatalogueOptions& options) {
  const auto done = valueOrFail(catalogue::storeClosed(options.file, options.target, options.catalogue));
  if (options.json) {
    printJson({{"from", options.file}, {"path", done.path}, {"bytes", done.bytes}, {"was_there", done.was_there}});
  } else {
    std::cout << fmt::format("{} -> {} ({} bytes, verified)\n", options.file, done.path, done.bytes);
  }
}

void runTag(const SessionCatalogueOptions& options) {
  valueOrUsage(catalogue::checkTags(options.add));
  catalogue::Catalogue catalogue = openCatalogue(options.catalogue, AbsentCatalogue::refused);
  const auto entry = entryFor(catalogue, options.target);
  std::set<std::string> tags(entry.tags.begin(), entry.tags.end());
  for (const std::string& tag : options.remove) {
    const std::string folded = catalogue::foldCase(tag);  // as --tag finds it
    const auto taken = std::erase_if(tags, [&](const std::string& has) { return catalogue::foldCase(has) == folded; });
    if (taken == 0) throw Failure(say("session {}: has no tag '{}'", entry.id, tag));
  }
  tags.insert(options.add.begin(), options.add.end());  // last, so that a tag's capitals can be changed
  valueOrFail(catalogue.setTags(entry.id, {tags.begin(), tags.end()}));
  const auto now = valueOrFail(catalogue.get(entry.id));
  if (options.json) {
    printJson(toJson(now));
  } else {
    printEntries({now});
  }
}

void runNotes(const SessionCatalogueOptions& options) {
  valueOrUsage(catalogue::checkNotes(options.notes));
  catalogue::Catalogue catalogue = openCatalogue(options.catalogue, AbsentCatalogue::refused);
  const auto entry = entryFor(catalogue, options.target);
  valueOrFail(catalogue.setNotes(entry.id, options.notes));
  const auto now = valueOrFail(catalogue.get(entry.id));
  if (options.json) {
    printJson(toJson(now));
  } else {
    std::cout << forTerminal(now.notes) << '\n';
  }
}

void runForget(const SessionCatalogueOptions& options) {
  catalogue::Catalogue catalogue = openCatalogue(options.catalogue, AbsentCatalogue::refused);
  const auto entry = entryFor(catalogue, options.target);
  valueOrFail(catalogue.remove(entry.id));
  if (options.json) {
    printJson(toJson(entry));
  } else {
    std::cout << fmt::format("{} is forgotten; its file stays: {}\n", entry.id, entry.path);
  }
}

}  // namespace

void addCatalogueOption(CLI::App& command, std::string& word) {
  command
      .add_option("--catalogue", word,
                  "sqlite:PATH or postgresql:host=… dbname=… user=… (the password from ~/.pgpass); "
                  "default: this user's own")
      ->check(goodFor(catalogue::parseCatalogueAddress));
}

void failUnread(const catalogue::ScanReport& report) {
  if (!report.unreadable.empty()) throw Failure(report.unreadable.front());
}

catalogue::Catalogue openCatalogue(const std::string& word, AbsentCatalogue absent) {
  const auto address = valueOrFail(catalogue::parseCatalogueAddress(word));
  std::error_code none;
  if (absent == AbsentCatalogue::refused && address.kind == catalogue::CatalogueAddress::Kind::sqlite &&
      !catalogue::isDefault(address) && !std::filesystem::exists(address.target, none) && !none) {
    throw Failure(say("{}: there is no catalogue; `fyd session add` makes one", address.target));
  }
  auto catalogue = valueOrFail(catalogue::Catalogue::open(word));
  const catalogue::PendingReport& pending = catalogue.pending();
  if (pending.delivered > 0) {
    std::cerr << fmt::format("fyd: {} entries that could not be written earlier are in the catalogue now\n",
                             pending.delivered);
  }
  if (!pending.problem.empty()) {
    std::cerr << fmt::format("fyd: {} entries still cannot be written into the catalogue: {}\n", pending.waiting,
                             pending.problem);
  }
  return catalogue;
}

void addSessionCatalogue(CLI::App& session) {
  const auto add = [&session](const char* name, const char* help, void (*run)(const SessionCatalogueOptions&)) {
    const auto options = std::make_shared<SessionCatalogueOptions>();
    CLI::App* command = session.add_subcommand(name, help);
    addCatalogueOption(*command, options->catalogue);
    command->add_flag("--json", options->json, "Result as JSON");
    command->callback([options, run] { run(*options); });
    return std::pair{command, options};
  };
  {
    const auto [command, options] = add("add", "Put recordings, or folders of them, into the catalogue", runAdd);
    command->add_option("files", options->paths, "Recordings; folders are remembered and searched later")->required();
  }
  {
    const auto [command, options] =
        add("store", "Move a closed recording to another folder: copy, verify, catalogue, then remove", runStore);
    command->add_option("file", options->file, "Recording")->required();
    command->add_option("folder", options->target, "Where to, such as mounted shared storage")->required();
  }
  constexpr const char* kTarget = "Session's id, its first digits, or its file";
  {
    const auto [command, options] = add("tag", "Change a session's tags in the catalogue", runTag);
    command->add_option("session", options->target, kTarget)->required();
    command->add_option("--add", options->add, "Tag to add; repeatable")->allow_extra_args(false);
    command->add_option("--remove", options->remove, "Tag to take away; repeatable")->allow_extra_args(false);
  }
  {
    const auto [command, options] = add("notes", "Replace a session's notes in the catalogue", runNotes);
    command->add_option("session", options->target, kTarget)->required();
    command->add_option("text", options->notes, "The new notes; '' for none")->required();
  }
  {
    const auto [command, options] = add("forget", "Take a session out of the catalogue; its file stays", runForget);
    command->add_option("session", options->target, kTarget)->required();
  }
}

}  // namespace fyd::cli
