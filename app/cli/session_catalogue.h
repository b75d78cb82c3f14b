// What the subcommands around the catalogue share.
#pragma once

#include <string>
#include <vector>

#include "app/cli/command.h"
#include "core/session/catalogue.h"

namespace fyd::cli {

/// add, store, tag, notes and forget.
void addSessionCatalogue(CLI::App& session);

void addCatalogueOption(CLI::App& command, std::string& word);
/// Failure when it cannot be opened. Entries that had waited are mentioned on standard error.
[[nodiscard]] session::Catalogue openCatalogue(const std::string& word);

[[nodiscard]] nlohmann::ordered_json toJson(const session::CatalogueEntry& entry);
[[nodiscard]] nlohmann::ordered_json toJson(const session::ScanReport& report);
/// One line, and one for each copy and unreadable file.
void printScan(const session::ScanReport& report);
/// An aligned table; control characters are shown as '?', so that a note cannot steer the terminal.
void printEntries(const std::vector<session::CatalogueEntry>& entries);

}  // namespace fyd::cli
