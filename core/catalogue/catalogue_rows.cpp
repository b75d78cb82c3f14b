#include "core/catalogue/catalogue_rows.h"

#include "core/catalogue/catalogue_text.h"

namespace fyd::catalogue {
namespace {

long long number(std::uint64_t value) { return static_cast<long long>(value); }

void bindFile(soci::statement& statement, EntryRow& row) {
  using soci::use;
  statement.exchange(use(row.entry.id, "id"));
  statement.exchange(use(row.entry.path, "path"));
  statement.exchange(use(row.entry.started_utc, "started_utc"));
  statement.exchange(use(row.started_ms, "started_ms"));
  statement.exchange(use(row.entry.duration_s, "duration_s"));
  statement.exchange(use(row.samples, "samples"));
  statement.exchange(use(row.gaps, "gaps"));
  statement.exchange(use(row.events, "events"));
  statement.exchange(use(row.wholeness, "wholeness"));
  statement.exchange(use(row.entry.health, "health"));
  statement.exchange(use(row.bytes, "bytes"));
  statement.exchange(use(row.file_modified_ns, "file_modified_ns"));
  statement.exchange(use(row.file_state, "file_state"));
}

void bindTexts(soci::statement& statement, EntryRow& row) {
  using soci::use;
  statement.exchange(use(row.entry.station, "station"));
  statement.exchange(use(row.entry.operator_name, "operator_name"));
  statement.exchange(use(row.entry.subject, "subject"));
  statement.exchange(use(row.entry.notes, "notes"));
  statement.exchange(use(row.entry.touchpad, "touchpad"));
  statement.exchange(use(row.entry.robot, "robot"));
  statement.exchange(use(row.search_text, "search_text"));
}

/// @return rows changed
long long execute(soci::statement& statement, const char* text) {
  statement.alloc();
  statement.prepare(text);
  statement.define_and_bind();
  statement.execute(true);
  return statement.get_affected_rows();
}

void addTags(soci::session& sql, const std::string& id, const std::vector<std::string>& tags) {
  for (const std::string& tag : tags) {
    const std::string folded = foldCase(tag);
    sql << "INSERT INTO session_tags (session_id, tag, folded) VALUES (:id, :tag, :folded)"
           " ON CONFLICT (session_id, folded) DO NOTHING",
        soci::use(id, "id"), soci::use(tag, "tag"), soci::use(folded, "folded");
  }
}

}  // namespace

EntryRow::EntryRow(const CatalogueEntry& from)
    : entry(from),
      started_ms(parseUtc(from.started_utc).value_or(UtcSpan{}).begin_ms),
      samples(number(from.samples)),
      gaps(number(from.gaps)),
      events(number(from.events)),
      bytes(number(from.bytes)),
      file_modified_ns(from.file_modified_ns),
      wholeness(toString(from.wholeness)),
      file_state(toString(from.file_state)),
      search_text(searchText(from)) {}

CatalogueEntry EntryRow::toEntry() const {
  CatalogueEntry out = entry;
  out.samples = static_cast<std::uint64_t>(samples);
  out.gaps = static_cast<std::uint64_t>(gaps);
  out.events = static_cast<std::uint64_t>(events);
  out.bytes = static_cast<std::uint64_t>(bytes);
  out.file_modified_ns = file_modified_ns;
  for (const recording::Wholeness word :
       {recording::Wholeness::growing, recording::Wholeness::crashed, recording::Wholeness::damaged}) {
    if (wholeness == toString(word)) out.wholeness = word;
  }
  for (const FileState word : {FileState::missing, FileState::replaced}) {
    if (file_state == toString(word)) out.file_state = word;
  }
  return out;
}

void putEntry(soci::session& sql, const CatalogueEntry& entry) {
  long long known = 0;
  sql << "SELECT count(*) FROM sessions WHERE id = :id", soci::use(entry.id, "id"), soci::into(known);
  EntryRow row(entry);
  soci::statement statement(sql);
  bindFile(statement, row);
  bindTexts(statement, row);
  execute(
      statement,
      "INSERT INTO sessions (id, path, station, started_utc, started_ms, duration_s, operator_name, subject, notes,"
      " touchpad, robot, samples, gaps, events, wholeness, health, bytes, file_modified_ns, file_state, search_text)"
      " VALUES (:id, :path, :station, :started_utc, :started_ms, :duration_s, :operator_name, :subject, :notes,"
      " :touchpad, :robot, :samples, :gaps, :events, :wholeness, :health, :bytes, :file_modified_ns, :file_state,"
      " :search_text)"
      " ON CONFLICT (id) DO UPDATE SET"
      " station = CASE WHEN sessions.path = excluded.path THEN sessions.station ELSE excluded.station END,"
      " path = excluded.path, started_utc = excluded.started_utc,"
      " started_ms = excluded.started_ms, duration_s = excluded.duration_s, samples = excluded.samples,"
      " gaps = excluded.gaps, events = excluded.events, wholeness = excluded.wholeness, health = excluded.health,"
      " bytes = excluded.bytes, file_modified_ns = excluded.file_modified_ns, file_state = excluded.file_state");
  if (known == 0) addTags(sql, entry.id, entry.tags);
}

bool replaceEntry(soci::session& sql, const CatalogueEntry& entry) {
  EntryRow row(entry);
  soci::statement statement(sql);
  bindFile(statement, row);
  bindTexts(statement, row);
  const long long changed = execute(
      statement,
      "UPDATE sessions SET path = :path, station = :station, started_utc = :started_utc, started_ms = :started_ms,"
      " duration_s = :duration_s, operator_name = :operator_name, subject = :subject, notes = :notes,"
      " touchpad = :touchpad, robot = :robot, samples = :samples, gaps = :gaps, events = :events,"
      " wholeness = :wholeness, health = :health, bytes = :bytes, file_modified_ns = :file_modified_ns,"
      " file_state = :file_state, search_text = :search_text WHERE id = :id");
  if (changed > 0) replaceTags(sql, entry.id, entry.tags);
  return changed > 0;
}

void replaceTags(soci::session& sql, const std::string& id, const std::vector<std::string>& tags) {
  sql << "DELETE FROM session_tags WHERE session_id = :id", soci::use(id, "id");
  addTags(sql, id, tags);
}

void refreshSearchText(soci::session& sql, const std::string& id) {
  for (const CatalogueEntry& entry : findEntries(sql, {.id = id})) {
    const std::string text = searchText(entry);
    sql << "UPDATE sessions SET search_text = :text WHERE id = :id", soci::use(text, "text"), soci::use(id, "id");
  }
}

}  // namespace fyd::catalogue
