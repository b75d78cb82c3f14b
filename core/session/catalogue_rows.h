// Entries as rows: the columns, and how a value gets in and out.
#pragma once

#include <string>
#include <vector>

#include "core/session/catalogue_database.h"
#include "core/session/catalogue_types.h"

namespace fyd::session {

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
/// The text that searches look in, from what the row holds now.
void refreshSearchText(soci::session& sql, const std::string& id);
/// Throws what SOCI throws.
[[nodiscard]] std::vector<CatalogueEntry> findEntries(soci::session& sql, const SessionFilter& filter);

}  // namespace fyd::session
