// The tables of the catalogue and of the waiting entries, and the upgrade of older ones.
#include <array>

#include "core/catalogue/catalogue_database.h"

namespace fyd::catalogue {
namespace {

// BIGINT, TEXT and DOUBLE PRECISION mean the same in both databases.
constexpr const char* kCatalogue1[] = {
    ("CREATE TABLE sessions ("
     " id TEXT PRIMARY KEY, path TEXT NOT NULL, station TEXT NOT NULL, started_utc TEXT NOT NULL,"
     " started_ms BIGINT NOT NULL, duration_s DOUBLE PRECISION NOT NULL, operator_name TEXT NOT NULL,"
     " subject TEXT NOT NULL, notes TEXT NOT NULL, touchpad TEXT NOT NULL, robot TEXT NOT NULL,"
     " samples BIGINT NOT NULL, gaps BIGINT NOT NULL, events BIGINT NOT NULL, wholeness TEXT NOT NULL,"
     " health TEXT NOT NULL, bytes BIGINT NOT NULL, file_modified_ns BIGINT NOT NULL, file_state TEXT NOT NULL,"
     " search_text TEXT NOT NULL)"),
    ("CREATE TABLE session_tags (session_id TEXT NOT NULL REFERENCES sessions (id) ON DELETE CASCADE,"
     " tag TEXT NOT NULL, folded TEXT NOT NULL, PRIMARY KEY (session_id, folded))"),
    "CREATE TABLE session_folders (station TEXT NOT NULL, path TEXT NOT NULL, PRIMARY KEY (station, path))",
    "CREATE INDEX sessions_started ON sessions (started_ms)",
    "CREATE INDEX sessions_station ON sessions (station)",
    "CREATE INDEX session_tags_folded ON session_tags (folded)"};
constexpr std::array<std::span<const char* const>, 1> kCatalogue = {kCatalogue1};

constexpr const char* kPending1[] = {
    "CREATE TABLE pending (catalogue TEXT NOT NULL, id TEXT NOT NULL, entry TEXT NOT NULL,"
    " queued_ms BIGINT NOT NULL, reason TEXT NOT NULL, PRIMARY KEY (catalogue, id))"};
constexpr std::array<std::span<const char* const>, 1> kPending = {kPending1};

}  // namespace

SchemaSteps catalogueSchema() { return kCatalogue; }
SchemaSteps pendingSchema() { return kPending; }

bool isOfAnother(soci::session& sqlite) {
  long long all = 0, ours = 0;
  sqlite << "SELECT count(*), count(nullif(name = 'catalogue_version', 0)) FROM sqlite_master", soci::into(all),
      soci::into(ours);
  return all > 0 && ours == 0;
}

Result<void> CatalogueDatabase::prepareSchema(SchemaSteps schema) {
  const bool is_sqlite = word_.kind == CatalogueAddress::Kind::sqlite;
  const auto version = [is_sqlite](soci::session& sql) -> Result<long long> {
    long long tables = 0;
    long long value = 0;
    sql << (is_sqlite ? "SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name = 'catalogue_version'"
                      : "SELECT count(*) FROM pg_catalog.pg_class WHERE oid = to_regclass('catalogue_version')"),
        soci::into(tables);
    if (tables > 0) sql << "SELECT coalesce(max(version), 0) FROM catalogue_version", soci::into(value);
    return value;
  };
  const auto newest = static_cast<long long>(schema.size());
  const auto present = read(version);
  if (!present) return tl::unexpected(present.error());
  if (*present > newest) {
    return fail("{}: made by a newer version of this program (tables {}, this one knows {})", word_.name, *present,
                newest);
  }
  if (*present == newest) return {};
  return write([&](soci::session& sql) -> Result<void> {
    if (!is_sqlite) sql << "SELECT pg_advisory_xact_lock(1719231587)";  // serialises the upgrade among stations
    const auto now = version(sql);
    if (*now >= newest) return {};
    if (is_sqlite && isOfAnother(sql))
      return fail("{}: is another program's database; expected a catalogue, or a new file", word_.name);
    if (*now == 0 && !is_sqlite) {
      // Others cannot hold every text. One that was made in such a database by an earlier version goes on.
      std::string encoding;
      sql << "SHOW server_encoding", soci::into(encoding);
      if (encoding != "UTF8") {
        return fail("{}: its server_encoding is {}; make the database with ENCODING 'UTF8'", word_.name, encoding);
      }
    }
    if (*now == 0) sql << "CREATE TABLE catalogue_version (version BIGINT NOT NULL)";
    for (long long step = *now; step < newest; ++step) {
      for (const char* statement : schema[static_cast<std::size_t>(step)]) sql << statement;
    }
    sql << "DELETE FROM catalogue_version";
    sql << "INSERT INTO catalogue_version (version) VALUES (:version)", soci::use(newest, "version");
    return {};
  });
}

}  // namespace fyd::catalogue
