// Catalogue entries as database rows: writing, reading and searching.
#pragma once

#include <string>
#include <vector>

#include "core/catalogue/catalogue_database.h"
#include "core/catalogue/catalogue_types.h"

namespace fyd::catalogue {

/// One row of `sessions`: SOCI binds these fields, which must stay where they are while a statement uses them.
struct EntryRow {
  EntryRow() = default;
  /// @param entry checked
  explicit EntryRow(const CatalogueEntry& entry);

  CatalogueEntry entry;
  long long started_ms = 0, samples = 0, gaps = 0, events = 0, bytes = 0, file_modified_ns = 0;
  std::string wholeness, file_state, search_text;

  /// The entry with what was read into the other fields.
  [[nodiscard]] CatalogueEntry toEntry() const;
};

/// Adds or refreshes; the caller holds the transaction.
void putEntry(soci::session& sql, const CatalogueEntry& entry);
/// @return false when there is no such entry
[[nodiscard]] bool replaceEntry(soci::session& sql, const CatalogueEntry& entry);
void replaceTags(soci::session& sql, const std::string& id, const std::vector<std::string>& tags);
/// Updates the row's search text from its other columns.
void refreshSearchText(soci::session& sql, const std::string& id);
/// Throws SOCI's exceptions.
[[nodiscard]] std::vector<CatalogueEntry> findEntries(soci::session& sql, const SessionFilter& filter);

}  // namespace fyd::catalogue
