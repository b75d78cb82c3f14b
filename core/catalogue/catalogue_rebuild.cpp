#include "core/catalogue/catalogue_rebuild.h"

#include <chrono>
#include <filesystem>
#include <set>

#include <soci/sqlite3/soci-sqlite3.h>

#include "core/base/system_reason.h"
#include "core/catalogue/catalogue_database.h"
#include "core/catalogue/catalogue_rows.h"
#include "core/catalogue/catalogue_text.h"

namespace fyd::catalogue {
namespace {

namespace fs = std::filesystem;

struct Rescued {
  std::vector<CatalogueEntry> entries;
  std::set<std::string> folders;
};

/// Collects a query's rows up to the first error.
void readTexts(soci::session& sql, const std::string& query, std::set<std::string>& out) {
  try {
    std::string text;
    BoundStatement statement(sql);
    statement.into(text);
    statement.execute(query);
    while (statement.fetch()) out.insert(text);
  } catch (const std::exception&) {  // damaged here: the next query may read other pages
  }
}

/// Reads every readable entry: notes and tags made in the catalogue are stored nowhere else.
Rescued rescue(const std::string& path) {
  Rescued out;
  try {
    soci::session sql(soci::sqlite3, fmt::format("dbname=\"{}\"", path));
    std::set<std::string> ids;
    readTexts(sql, "SELECT id FROM sessions NOT INDEXED", ids);
    readTexts(sql, "SELECT id FROM sessions ORDER BY id", ids);
    readTexts(sql, "SELECT path FROM session_folders", out.folders);
    for (const std::string& id : ids) {
      try {
        for (CatalogueEntry& entry : findEntries(sql, {.id = id})) {
          if (checkEntry(entry)) out.entries.push_back(std::move(entry));
        }
      } catch (const std::exception&) {  // this row is lost; its recording will be read again
      }
    }
  } catch (const std::exception&) {  // not a database any more
  }
  return out;
}

/// The name, or the name with the first number that makes it new.
std::string freeName(const std::string& name) {
  std::string out = name;
  std::error_code error;
  for (int n = 2; fs::exists(out, error); ++n) out = fmt::format("{}-{}", name, n);
  return out;
}

/// A SQLite file's parts; the log comes first, or the file that gets this name next would read it.
constexpr const char* kParts[] = {"-wal", "-shm", ""};

Result<void> renameDatabase(const std::string& from, const std::string& to) {
  std::error_code error;
  for (const char* part : kParts) {
    if (!fs::exists(from + part, error)) continue;
    fs::rename(from + part, to + part, error);
    if (error) return fail("{}{}: cannot be renamed to {}: {}", from, part, to, systemReason(error));
  }
  return {};
}

std::string nameAside(const std::string& path) {
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  const std::chrono::year_month_day day(std::chrono::floor<std::chrono::days>(now));
  const std::chrono::hh_mm_ss time(now - std::chrono::floor<std::chrono::days>(now));
  return freeName(fmt::format("{}.damaged-{:04}{:02}{:02}-{:02}{:02}{:02}", path, int{day.year()},
                              unsigned{day.month()}, unsigned{day.day()}, time.hours().count(), time.minutes().count(),
                              time.seconds().count()));
}

/// A new catalogue that is removed again unless it got its name.
struct FreshCatalogue {
  explicit FreshCatalogue(std::string file) : path(std::move(file)) {}
  FreshCatalogue(const FreshCatalogue&) = delete;
  FreshCatalogue& operator=(const FreshCatalogue&) = delete;
  ~FreshCatalogue() {
    std::error_code ignored;
    for (const char* part : kParts) {
      if (!path.empty()) fs::remove(path + part, ignored);
    }
  }
  std::string path;
};

/// Puts a new catalogue in place of the damaged one. Under another name it gets the rescued entries first: what fails
/// until then leaves the damaged file where it is, and what waits for this catalogue finds their notes and tags there.
/// @return where the damaged one is now
Result<std::string> replaceDamaged(const std::string& path, const std::vector<CatalogueEntry>& rescued) {
  FreshCatalogue fresh(freeName(path + ".new"));
  const auto filled =
      Catalogue::open("sqlite:" + fresh.path).and_then([&](Catalogue catalogue) { return catalogue.add(rescued); });
  if (!filled) return tl::unexpected(filled.error());
  const std::string aside = nameAside(path);
  if (auto moved = renameDatabase(path, aside); !moved) return tl::unexpected(moved.error());
  if (auto placed = renameDatabase(fresh.path, path); !placed) {
    fresh.path.clear();  // the entries are taken over in it
    return fail("{}; the damaged catalogue is {} now", placed.error().message, aside);
  }
  fresh.path.clear();
  return aside;
}

/// Reads the recordings of these folders, and of those that the catalogue knows.
Result<void> readFolders(Catalogue& catalogue, std::set<std::string> all, const EntryReader& read,
                         RebuildReport& report) {
  const auto remembered = catalogue.folders();
  if (!remembered) return tl::unexpected(remembered.error());
  all.insert(remembered->begin(), remembered->end());
  for (const std::string& folder : all) {
    const auto scan = catalogue.addFolder(folder, read);
    if (!scan) {
      report.scan.unreadable.push_back(scan.error().message);
      continue;
    }
    report.folders.push_back(folder);
    report.scan.added += scan->added;
    report.scan.known += scan->known;
    report.scan.copies.insert(report.scan.copies.end(), scan->copies.begin(), scan->copies.end());
    report.scan.unreadable.insert(report.scan.unreadable.end(), scan->unreadable.begin(), scan->unreadable.end());
  }
  return {};
}

}  // namespace

Result<RebuildReport> rebuildCatalogue(const std::string& word, const std::vector<std::string>& folders,
                                       const EntryReader& read) {
  const auto parsed = parseCatalogueAddress(word);
  if (!parsed) return tl::unexpected(parsed.error());
  RebuildReport report;
  Rescued rescued;
  if (parsed->kind == CatalogueAddress::Kind::sqlite) {
    const auto damaged = isDamaged(parsed->target);
    if (!damaged) return tl::unexpected(damaged.error());
    if (*damaged) {
      rescued = rescue(parsed->target);
      auto aside = replaceDamaged(parsed->target, rescued.entries);
      if (!aside) return tl::unexpected(aside.error());
      report.moved_aside = *aside;
      report.rescued = rescued.entries.size();
    }
  }
  std::set<std::string> all = std::move(rescued.folders);
  for (const std::string& folder : folders) {
    std::error_code error;
    all.insert(fs::weakly_canonical(folder, error));
  }
  const auto done = Catalogue::open(word).and_then(
      [&](Catalogue catalogue) { return readFolders(catalogue, std::move(all), read, report); });
  if (done) return report;
  if (report.moved_aside.empty()) return tl::unexpected(done.error());
  return fail("{}; the damaged catalogue is {} now", done.error().message, report.moved_aside);
}

}  // namespace fyd::catalogue
