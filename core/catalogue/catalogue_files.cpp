// Updates the catalogue from the files: new folders, and recordings that were moved, changed or lost.
#include <filesystem>
#include <map>
#include <set>

#include "core/base/system_reason.h"
#include "core/catalogue/catalogue.h"
#include "core/catalogue/catalogue_database.h"
#include "core/catalogue/catalogue_scan.h"
#include "core/catalogue/catalogue_text.h"

namespace fyd::catalogue {
namespace {

constexpr std::size_t kEntriesPerTransaction = 200;

/// Index of the entries by path and by id.
struct Known {
  explicit Known(std::vector<CatalogueEntry> entries) {
    for (CatalogueEntry& entry : entries) put(std::move(entry));
  }
  void put(CatalogueEntry entry) {
    id_of[entry.path] = entry.id;
    const std::string id = entry.id;
    by_id.insert_or_assign(id, std::move(entry));
  }
  [[nodiscard]] bool has(const std::string& path) const {
    const auto id = id_of.find(path);
    if (id == id_of.end()) return false;
    const CatalogueEntry& entry = by_id.at(id->second);
    const auto facts = fileFacts(path);
    return facts && entry.path == path && entry.file_state == FileState::present && isUnchanged(entry, *facts);
  }

  std::map<std::string, std::string> id_of;
  std::map<std::string, CatalogueEntry> by_id;
};

/// Whether the file at the entry's path is still its recording.
bool isStillThere(const CatalogueEntry& entry, const EntryReader& read) {
  const auto facts = fileFacts(entry.path);
  if (!facts) return false;
  if (isUnchanged(entry, *facts)) return true;
  const auto now = read(entry.path);
  return now && now->id == entry.id;
}

}  // namespace

const char* toString(FileChange::Kind kind) {
  switch (kind) {
    case FileChange::Kind::moved: return "moved";
    case FileChange::Kind::missing: return "missing";
    case FileChange::Kind::changed: return "changed";
    case FileChange::Kind::replaced: return "replaced";
    case FileChange::Kind::returned: return "returned";
    case FileChange::Kind::unreadable: return "unreadable";
  }
  return "?";
}

Result<std::vector<std::string>> Catalogue::folders() const {
  return database_->read([](soci::session& sql) -> Result<std::vector<std::string>> {
    std::string path;
    BoundStatement statement(sql);
    statement.bind("station", stationName());
    statement.into(path);
    statement.execute("SELECT path FROM session_folders WHERE station = :station ORDER BY path");
    std::vector<std::string> out;
    while (statement.fetch()) out.push_back(path);
    return out;
  });
}

Result<ScanReport> Catalogue::addFolder(const std::string& path, const EntryReader& read) {
  std::error_code error;
  const std::string folder = std::filesystem::canonical(path, error);
  if (error) return fail(about(path, systemReason(error)));
  if (!std::filesystem::is_directory(folder, error)) return fail("{}: expected a folder", path);
  if (auto ok = checkNotes(folder); !ok) return fail("folder: {}", ok.error().message);
  const auto remembered = database_->write([&](soci::session& sql) -> Result<void> {
    const std::string station = stationName();
    sql << "INSERT INTO session_folders (station, path) VALUES (:station, :path)"
           " ON CONFLICT (station, path) DO NOTHING",
        soci::use(station, "station"), soci::use(folder, "path");
    return {};
  });
  if (!remembered) return tl::unexpected(remembered.error());
  auto entries = search({});
  if (!entries) return tl::unexpected(entries.error());

  Known known(std::move(*entries));
  ScanReport report;
  std::vector<CatalogueEntry> batch;
  FoundRecordings found = recordingsIn(folder, true);
  report.unreadable = std::move(found.problems);
  for (const std::string& file : found.files) {
    if (known.has(file)) {
      ++report.known;
      continue;
    }
    auto entry = read(file);
    if (!entry) {
      report.unreadable.push_back(entry.error().message);
      continue;
    }
    const auto same = known.by_id.find(entry->id);
    // Another station's file cannot be looked for here.
    if (same != known.by_id.end() && same->second.path != entry->path &&
        (same->second.station != stationName() || isStillThere(same->second, read))) {
      report.copies.push_back(entry->path);
      continue;
    }
    ++(same == known.by_id.end() ? report.added : report.known);
    batch.push_back(*entry);
    known.put(std::move(*entry));
    if (batch.size() < kEntriesPerTransaction) continue;
    if (auto ok = add(batch); !ok) return tl::unexpected(ok.error());
    batch.clear();
  }
  if (auto ok = add(batch); !ok) return tl::unexpected(ok.error());
  return report;
}

Result<std::vector<FileChange>> Catalogue::checkFiles(const EntryReader& read) {
  using Kind = FileChange::Kind;
  auto own = search({.station = stationName(), .order = SessionOrder::path, .descending = false});
  if (!own) return tl::unexpected(own.error());
  const auto remembered = folders();
  if (!remembered) return tl::unexpected(remembered.error());

  std::vector<FileChange> changes;
  std::map<std::string, FileChange> gone;  // by id
  std::set<std::string> parents;
  for (const CatalogueEntry& entry : *own) {
    parents.insert(std::filesystem::path(entry.path).parent_path());
    FileChange change{.id = entry.id, .old_path = entry.path};
    const auto facts = fileFacts(entry.path);
    if (facts && isUnchanged(entry, *facts)) {
      if (entry.file_state == FileState::present) continue;
      change.kind = Kind::returned;
      if (auto ok = markFile(entry.id, FileState::present); !ok) return tl::unexpected(ok.error());
      changes.push_back(change);
      continue;
    }
    const auto now = facts ? read(entry.path) : Result<CatalogueEntry>(fail("gone"));
    if (now && now->id == entry.id) {
      change.kind = entry.file_state == FileState::present ? Kind::changed : Kind::returned;
      if (auto ok = add(*now); !ok) return tl::unexpected(ok.error());
      changes.push_back(change);
      continue;
    }
    change.kind = !facts ? Kind::missing : now ? Kind::replaced : Kind::unreadable;
    if (change.kind == Kind::unreadable) change.problem = now.error().message;
    gone.emplace(entry.id, change);
  }
  if (gone.empty()) return changes;

  const Known known(std::move(*own));
  std::set<std::string> candidates;
  Message unsearched;  // the first folder that could not be: what is missing may be there
  const auto consider = [&](const std::string& folder, bool deep) {
    FoundRecordings seen = recordingsIn(folder, deep);
    for (std::string& file : seen.files) candidates.insert(std::move(file));
    if (unsearched.empty() && !seen.problems.empty()) unsearched = std::move(seen.problems.front());
  };
  for (const std::string& folder : *remembered) consider(folder, true);
  for (const std::string& folder : parents) consider(folder, false);
  for (const std::string& file : candidates) {
    if (gone.empty()) break;
    if (known.has(file)) continue;
    const auto found = read(file);
    const auto wanted = found ? gone.find(found->id) : gone.end();
    if (wanted == gone.end()) continue;
    if (auto ok = add(*found); !ok) return tl::unexpected(ok.error());
    wanted->second.kind = Kind::moved;
    wanted->second.new_path = found->path;
    changes.push_back(wanted->second);
    gone.erase(wanted);
  }
  for (auto& [id, change] : gone) {
    if (change.kind == Kind::missing && !unsearched.empty()) {
      change.kind = Kind::unreadable;
      change.problem = unsearched;
    }
    if (change.kind != Kind::unreadable) {
      const FileState state = change.kind == Kind::replaced ? FileState::replaced : FileState::missing;
      if (auto ok = markFile(id, state); !ok) return tl::unexpected(ok.error());
    }
    changes.push_back(change);
  }
  return changes;
}

}  // namespace fyd::catalogue
