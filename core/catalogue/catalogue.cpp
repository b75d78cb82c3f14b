#include "core/catalogue/catalogue.h"

#include <algorithm>

#include "core/catalogue/catalogue_pending.h"
#include "core/catalogue/catalogue_rows.h"
#include "core/catalogue/catalogue_text.h"

namespace fyd::catalogue {

Catalogue::Catalogue(std::unique_ptr<CatalogueDatabase> database) : database_(std::move(database)) {}
Catalogue::Catalogue(Catalogue&&) noexcept = default;
Catalogue& Catalogue::operator=(Catalogue&&) noexcept = default;
Catalogue::~Catalogue() = default;

Result<Catalogue> Catalogue::open(const std::string& word) {
  const auto parsed = parseCatalogueAddress(word);
  if (!parsed) return tl::unexpected(parsed.error());
  auto database = CatalogueDatabase::open(*parsed, catalogueSchema());
  if (!database) return tl::unexpected(database.error());
  Catalogue out(std::move(*database));
  out.pending_ = deliverPending(parsed->key, [&out](const CatalogueEntry& entry) -> Delivery {
    if (auto good = checkEntry(entry); !good) return {Delivered::refused, good.error().message};
    const auto added = out.add(entry);
    if (added) return {};
    return {out.database_->refusedValues() ? Delivered::refused : Delivered::unreachable, added.error().message};
  });
  return out;
}

Result<Catalogue> Catalogue::inMemory() {
  auto database = CatalogueDatabase::open({.target = kInMemory, .name = "memory", .key = ""}, catalogueSchema());
  if (!database) return tl::unexpected(database.error());
  return Catalogue(std::move(*database));
}

const std::string& Catalogue::name() const { return database_->word().name; }

Result<void> Catalogue::add(const CatalogueEntry& entry) { return add(std::span(&entry, 1)); }

Result<void> Catalogue::add(std::span<const CatalogueEntry> entries) {
  for (const CatalogueEntry& entry : entries) {
    if (auto ok = checkEntry(entry); !ok) return ok;
  }
  return database_->write([&](soci::session& sql) -> Result<void> {
    for (const CatalogueEntry& entry : entries) putEntry(sql, entry);
    return {};
  });
}

Result<void> Catalogue::addAsOwn(const CatalogueEntry& entry) {
  if (auto ok = checkEntry(entry); !ok) return ok;
  return database_->write([&](soci::session& sql) -> Result<void> {
    putEntry(sql, entry);
    const std::string station = stationName();
    sql << "UPDATE sessions SET station = :station WHERE id = :id", soci::use(station, "station"),
        soci::use(entry.id, "id");
    return {};
  });
}

Result<void> Catalogue::update(const CatalogueEntry& entry) {
  if (auto ok = checkEntry(entry); !ok) return ok;
  return database_->write([&](soci::session& sql) -> Result<void> {
    if (!replaceEntry(sql, entry)) return fail("session '{}': not in {}", entry.id, name());
    return {};
  });
}

Result<void> Catalogue::setNotes(const std::string& id, const std::string& notes) {
  if (auto ok = checkNotes(notes); !ok) return ok;
  return database_->write([&](soci::session& sql) -> Result<void> {
    soci::statement change = (sql.prepare << "UPDATE sessions SET notes = :notes WHERE id = :id",
                              soci::use(notes, "notes"), soci::use(id, "id"));
    change.execute(true);
    if (change.get_affected_rows() == 0) return fail("session '{}': not in {}", id, name());
    refreshSearchText(sql, id);
    return {};
  });
}

Result<void> Catalogue::setTags(const std::string& id, const std::vector<std::string>& tags) {
  if (auto ok = checkTags(tags); !ok) return ok;
  return database_->write([&](soci::session& sql) -> Result<void> {
    // Changing the row first makes a second station wait here, so that neither overwrites the other's search text.
    soci::statement change =
        (sql.prepare << "UPDATE sessions SET search_text = '' WHERE id = :id", soci::use(id, "id"));
    change.execute(true);
    if (change.get_affected_rows() == 0) return fail("session '{}': not in {}", id, name());
    replaceTags(sql, id, tags);
    refreshSearchText(sql, id);
    return {};
  });
}

Result<void> Catalogue::setPath(const std::string& id, const std::string& path) {
  if (auto ok = checkNotes(path); !ok) return fail("path: {}", ok.error().message);
  return database_->write([&](soci::session& sql) -> Result<void> {
    const std::string present = toString(FileState::present);
    soci::statement change = (sql.prepare << "UPDATE sessions SET path = :path, file_state = :state WHERE id = :id",
                              soci::use(path, "path"), soci::use(present, "state"), soci::use(id, "id"));
    change.execute(true);
    if (change.get_affected_rows() == 0) return fail("session '{}': not in {}", id, name());
    return {};
  });
}

Result<void> Catalogue::markFile(const std::string& id, FileState state) {
  return database_->write([&](soci::session& sql) -> Result<void> {
    const std::string word = toString(state);
    sql << "UPDATE sessions SET file_state = :state WHERE id = :id", soci::use(word, "state"), soci::use(id, "id");
    return {};
  });
}

Result<void> Catalogue::remove(const std::string& id) {
  return database_->write([&](soci::session& sql) -> Result<void> {
    soci::statement change = (sql.prepare << "DELETE FROM sessions WHERE id = :id", soci::use(id, "id"));
    change.execute(true);
    if (change.get_affected_rows() == 0) return fail("session '{}': not in {}", id, name());
    return {};
  });
}

}  // namespace fyd::catalogue
