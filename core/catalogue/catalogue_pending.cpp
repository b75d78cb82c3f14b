#include "core/catalogue/catalogue_pending.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/catalogue/catalogue_address.h"
#include "core/catalogue/catalogue_database.h"

namespace fyd::recording {

// In the namespace of the enum, or nlohmann's library does not find them and takes its number.
static void to_json(nlohmann::json& json, const Wholeness& wholeness) { json = catalogue::toString(wholeness); }

static void from_json(const nlohmann::json& json, Wholeness& wholeness) {
  // Queues of earlier versions hold the number that the word had then: its place here.
  constexpr std::array kWords = {Wholeness::whole, Wholeness::growing, Wholeness::crashed, Wholeness::damaged};
  if (json.is_number()) {
    wholeness = kWords.at(json.get<std::size_t>());
    return;
  }
  const auto word = json.get<std::string>();
  const auto* const found =
      std::ranges::find_if(kWords, [&](Wholeness known) { return word == catalogue::toString(known); });
  if (found == kWords.end()) throw std::invalid_argument("wholeness: " + word);
  wholeness = *found;
}

}  // namespace fyd::recording

namespace fyd::catalogue {

// The file's state is not kept: it was there when the entry was made.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(CatalogueEntry, id, path, station, started_utc, duration_s,
                                                operator_name, subject, tags, notes, touchpad, robot, samples, gaps,
                                                events, wholeness, health, bytes, file_modified_ns)

namespace {

Result<std::unique_ptr<CatalogueDatabase>> openQueue() {
  const auto word = parseCatalogueAddress("sqlite:" + pendingPath());
  if (!word) return tl::unexpected(word.error());
  return CatalogueDatabase::open(*word, pendingSchema());
}

Result<CatalogueEntry> parseEntry(const std::string& text) {
  try {
    return nlohmann::json::parse(text).get<CatalogueEntry>();
  } catch (const std::exception& error) {
    return fail(verbatim(error.what()));
  }
}

struct Waiting {
  std::string id;
  std::string entry;
  long long queued_ms = 0;
};

Result<std::vector<Waiting>> waitingFor(CatalogueDatabase& queue, const std::string& key) {
  return queue.read([&](soci::session& sql) -> Result<std::vector<Waiting>> {
    Waiting row;
    BoundStatement statement(sql);
    statement.bind("key", key);
    statement.into(row.id);
    statement.into(row.entry);
    statement.into(row.queued_ms);
    statement.execute("SELECT id, entry, queued_ms FROM pending WHERE catalogue = :key ORDER BY queued_ms, id");
    std::vector<Waiting> out;
    while (statement.fetch()) out.push_back(row);
    return out;
  });
}

}  // namespace

Result<void> queueEntry(const std::string& key, const CatalogueEntry& entry, const std::string& reason) {
  auto queue = openQueue();
  if (!queue) return tl::unexpected(queue.error());
  return (*queue)->write([&](soci::session& sql) -> Result<void> {
    const std::string text = nlohmann::json(entry).dump();
    const long long now_ms =
        std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::system_clock::now().time_since_epoch())
            .count();
    sql << "INSERT INTO pending (catalogue, id, entry, queued_ms, reason) VALUES (:key, :id, :entry, :now, :reason)"
           " ON CONFLICT (catalogue, id) DO UPDATE SET entry = excluded.entry, queued_ms = excluded.queued_ms,"
           " reason = excluded.reason",
        soci::use(key, "key"), soci::use(entry.id, "id"), soci::use(text, "entry"), soci::use(now_ms, "now"),
        soci::use(reason, "reason");
    return {};
  });
}

PendingReport deliverPending(const std::string& key, const std::function<Delivery(const CatalogueEntry&)>& deliver) {
  PendingReport report;
  std::error_code error;
  if (!std::filesystem::exists(pendingPath(), error)) return report;
  const auto queue = openQueue();
  if (!queue) return {.problem = queue.error().message};
  const auto waiting = waitingFor(**queue, key);
  if (!waiting) return {.problem = waiting.error().message};
  report.waiting = waiting->size();
  for (const Waiting& row : *waiting) {
    const auto entry = parseEntry(row.entry);
    if (!entry) {  // its row stays, and the others are delivered
      report.problem = say("{}: the entry {} is damaged: {}", pendingPath(), row.id, entry.error().message);
      continue;
    }
    const Delivery delivery = deliver(*entry);
    if (delivery.delivered != Delivered::yes) report.problem = delivery.problem;
    if (delivery.delivered == Delivered::unreachable) break;
    if (delivery.delivered == Delivered::refused) continue;
    const auto removed = (*queue)->write([&](soci::session& sql) -> Result<void> {
      sql << "DELETE FROM pending WHERE catalogue = :key AND id = :id AND queued_ms = :queued", soci::use(key, "key"),
          soci::use(row.id, "id"), soci::use(row.queued_ms, "queued");
      return {};
    });
    if (!removed) {  // the queue is locked, full or damaged: the same for the next
      report.problem = removed.error().message;
      break;
    }
    ++report.delivered;
    --report.waiting;
  }
  return report;
}

}  // namespace fyd::catalogue
