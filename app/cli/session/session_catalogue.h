// Helpers of the subcommands that use the catalogue.
#pragma once

#include <string>
#include <vector>

#include "app/cli/parts/command.h"
#include "core/catalogue/catalogue.h"

namespace fyd::cli {

/// add, store, tag, notes and forget.
void addSessionCatalogue(CLI::App& session);

void addCatalogueOption(CLI::App& command, std::string& word);
/// What happens to a SQLite file that is not there. This user's own catalogue is always made.
enum class AbsentCatalogue { made, refused };
/// Failure when it cannot be opened. Entries that had waited are mentioned on standard error.
[[nodiscard]] catalogue::Catalogue openCatalogue(const std::string& word, AbsentCatalogue absent);

[[nodiscard]] nlohmann::ordered_json toJson(const catalogue::CatalogueEntry& entry);
[[nodiscard]] nlohmann::ordered_json toJson(const catalogue::ScanReport& report);
/// Failure with the first file or folder that could not be read.
void failUnread(const catalogue::ScanReport& report);
/// One line, and one for each copy and unreadable file.
void printScan(const catalogue::ScanReport& report);
/// Only those of the copies and unreadable files.
void printLeftOut(const catalogue::ScanReport& report);
/// An aligned table; control characters are shown as '?', so that a note cannot steer the terminal.
void printEntries(const std::vector<catalogue::CatalogueEntry>& entries);

}  // namespace fyd::cli
