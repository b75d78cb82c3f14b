// Searching: fixed clauses joined by AND, each value a bound parameter.
#include <algorithm>
#include <limits>

#include "core/catalogue/catalogue.h"
#include "core/catalogue/catalogue_rows.h"
#include "core/catalogue/catalogue_text.h"

namespace fyd::catalogue {
namespace {

constexpr std::size_t kMostWords = 32;

/// A filter's clauses, and its values in the order of their names.
struct Where {
  std::string text = " WHERE 1 = 1";
  std::vector<std::pair<std::string, std::string>> texts;
  std::vector<std::pair<std::string, long long>> numbers;

  void add(std::string_view clause, const std::string& name, std::string value) {
    text += fmt::format(" AND {}", clause);
    texts.emplace_back(name, std::move(value));
  }
  void bind(BoundStatement& statement) const {
    for (const auto& [name, value] : texts) statement.bind(name, value);
    for (const auto& [name, value] : numbers) statement.bind(name, value);
  }
};

/// @param filter checked
Where whereOf(const SessionFilter& filter) {
  Where where;
  const auto words = splitWords(filter.text);
  for (std::size_t i = 0; i < words.size(); ++i) {
    where.add(fmt::format("s.search_text LIKE :word{} ESCAPE '!'", i), fmt::format("word{}", i),
              likeAnywhere(foldCase(words[i])));
  }
  for (std::size_t i = 0; i < filter.tags.size(); ++i) {
    where.add(fmt::format("EXISTS (SELECT 1 FROM session_tags g WHERE g.session_id = s.id AND g.folded = :tag{})", i),
              fmt::format("tag{}", i), foldCase(filter.tags[i]));
  }
  if (!filter.operator_name.empty()) where.add("s.operator_name = :operator", "operator", filter.operator_name);
  if (!filter.subject.empty()) where.add("s.subject = :subject", "subject", filter.subject);
  if (!filter.station.empty()) where.add("s.station = :station", "station", filter.station);
  if (!filter.health.empty()) where.add("s.health = :health", "health", filter.health);
  if (!filter.id.empty()) where.add("s.id = :id", "id", filter.id);
  if (!filter.since.empty()) {
    where.text += " AND s.started_ms >= :since";
    where.numbers.emplace_back("since", parseUtc(filter.since)->begin_ms);
  }
  if (!filter.until.empty()) {
    where.text += " AND s.started_ms < :until";
    where.numbers.emplace_back("until", parseUtc(filter.until)->end_ms);
  }
  return where;
}

const char* columnOf(SessionOrder order) {
  switch (order) {
    case SessionOrder::started: return "started_ms";
    case SessionOrder::duration: return "duration_s";
    case SessionOrder::operator_name: return "operator_name";
    case SessionOrder::subject: return "subject";
    case SessionOrder::bytes: return "bytes";
    case SessionOrder::path: return "path";
  }
  return "started_ms";
}

}  // namespace

Result<void> checkFilter(const SessionFilter& filter) {
  if (splitWords(filter.text).size() > kMostWords || filter.text.size() > 4096) {
    return fail("search text: {} bytes, at most {} words are looked for", filter.text.size(), kMostWords);
  }
  if (auto ok = checkNotes(filter.text); !ok) return fail("search text: {}", ok.error().message);
  if (auto ok = checkTags(filter.tags); !ok) return ok;
  for (const std::string* text :
       {&filter.operator_name, &filter.subject, &filter.station, &filter.health, &filter.id}) {
    if (auto ok = checkNotes(*text); !ok) return fail("filter: {}", ok.error().message);
  }
  for (const std::string* time : {&filter.since, &filter.until}) {
    if (time->empty()) continue;
    if (auto span = parseUtc(*time); !span) return tl::unexpected(span.error());
  }
  return {};
}

std::vector<CatalogueEntry> findEntries(soci::session& sql, const SessionFilter& filter) {
  const Where where = whereOf(filter);
  const std::string order = fmt::format("{} {}, id", columnOf(filter.order), filter.descending ? "DESC" : "ASC");
  constexpr auto kColumns =
      "id, path, station, started_utc, started_ms, duration_s, operator_name, subject, notes, touchpad, robot, samples,"
      " gaps, events, wholeness, health, bytes, file_modified_ns, file_state";
  EntryRow row;
  CatalogueEntry& entry = row.entry;
  std::string tag;
  BoundStatement statement(sql);
  where.bind(statement);
  constexpr long long kAll = std::numeric_limits<long long>::max();
  const auto bounded = [](std::size_t n) { return static_cast<long long>(std::min<std::size_t>(n, kAll)); };
  statement.bind("limit", filter.limit == 0 ? kAll : bounded(filter.limit));
  statement.bind("offset", bounded(filter.offset));
  for (std::string* text : {&entry.id, &entry.path, &entry.station, &entry.started_utc}) statement.into(*text);
  statement.into(row.started_ms);
  statement.into(entry.duration_s);
  for (std::string* text : {&entry.operator_name, &entry.subject, &entry.notes, &entry.touchpad, &entry.robot}) {
    statement.into(*text);
  }
  for (long long* number : {&row.samples, &row.gaps, &row.events}) statement.into(*number);
  for (std::string* text : {&row.wholeness, &entry.health}) statement.into(*text);
  for (long long* number : {&row.bytes, &row.file_modified_ns}) statement.into(*number);
  statement.into(row.file_state);
  statement.into(tag);
  // One row per tag, in one query: a second one could see a later state.
  statement.execute(fmt::format(
      "SELECT p.*, coalesce(t.tag, '') FROM (SELECT {} FROM sessions s{} ORDER BY {} LIMIT :limit OFFSET :offset) p"
      " LEFT JOIN session_tags t ON t.session_id = p.id ORDER BY {}",
      kColumns, where.text, order, order));
  std::vector<CatalogueEntry> out;
  while (statement.fetch()) {
    if (out.empty() || out.back().id != entry.id) out.push_back(row.toEntry());
    if (!tag.empty()) out.back().tags.push_back(tag);
  }
  for (CatalogueEntry& found : out) std::ranges::sort(found.tags);
  return out;
}

Result<std::vector<CatalogueEntry>> Catalogue::search(const SessionFilter& filter) const {
  if (auto ok = checkFilter(filter); !ok) return tl::unexpected(ok.error());
  return database_->read(
      [&](soci::session& sql) -> Result<std::vector<CatalogueEntry>> { return findEntries(sql, filter); });
}

Result<std::size_t> Catalogue::count(const SessionFilter& filter) const {
  if (auto ok = checkFilter(filter); !ok) return tl::unexpected(ok.error());
  return database_->read([&](soci::session& sql) -> Result<std::size_t> {
    const Where where = whereOf(filter);
    long long found = 0;
    BoundStatement statement(sql);
    where.bind(statement);
    statement.into(found);
    statement.execute("SELECT count(*) FROM sessions s" + where.text);
    if (!statement.fetch()) found = 0;
    return static_cast<std::size_t>(found);
  });
}

Result<CatalogueEntry> Catalogue::get(const std::string& id) const {
  if (id.empty()) return fail("session '': an empty id names no session");  // a filter of none would find them all
  auto exact = search({.id = id});
  if (!exact) return tl::unexpected(exact.error());
  if (!exact->empty()) return exact->front();
  if (id.size() >= 4) {
    const std::string pattern = likeAnywhere(id).substr(1);  // from the beginning only
    const auto full = database_->read([&](soci::session& sql) -> Result<std::string> {
      std::string found;
      std::string first;
      BoundStatement statement(sql);
      statement.bind("pattern", pattern);
      statement.into(found);
      statement.execute("SELECT id FROM sessions WHERE id LIKE :pattern ESCAPE '!' ORDER BY id LIMIT 2");
      while (statement.fetch()) {
        if (!first.empty()) return fail("session '{}': several begin so; give more digits", id);
        first = found;
      }
      return first;
    });
    if (!full) return tl::unexpected(full.error());
    if (!full->empty()) return get(*full);
  }
  return fail("session '{}': not in {}", id, name());
}

}  // namespace fyd::catalogue
