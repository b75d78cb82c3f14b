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

/// @return the new name
Result<std::string> moveAside(const std::string& path) {
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  const std::chrono::year_month_day day(std::chrono::floor<std::chrono::days>(now));
  const std::chrono::hh_mm_ss time(now - std::chrono::floor<std::chrono::days>(now));
  const std::string stem =
      fmt::format("{}.damaged-{:04}{:02}{:02}-{:02}{:02}{:02}", path, int{day.year()}, unsigned{day.month()},
                  unsigned{day.day()}, time.hours().count(), time.minutes().count(), time.seconds().count());
  std::string aside = stem;
  std::error_code error;
  for (int n = 2; fs::exists(aside, error); ++n) aside = fmt::format("{}-{}", stem, n);
  for (const char* part : {"-wal", "-shm", ""}) {  // the log is moved with its file, or the new database would read it
    if (!fs::exists(path + part, error)) continue;
    fs::rename(path + part, aside + part, error);
    if (error) return fail("{}{}: cannot be moved aside to {}: {}", path, part, aside, systemReason(error));
  }
  return aside;
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
      auto aside = moveAside(parsed->target);
      if (!aside) return tl::unexpected(aside.error());
      report.moved_aside = *aside;
    }
  }
  auto catalogue = Catalogue::open(word);
  if (!catalogue) return tl::unexpected(catalogue.error());
  if (auto ok = catalogue->add(rescued.entries); !ok) return tl::unexpected(ok.error());
  report.rescued = rescued.entries.size();

  const auto remembered = catalogue->folders();
  if (!remembered) return tl::unexpected(remembered.error());
  std::set<std::string> all = std::move(rescued.folders);
  all.insert(remembered->begin(), remembered->end());
  for (const std::string& folder : folders) {
    std::error_code error;
    all.insert(fs::weakly_canonical(folder, error));
  }
  for (const std::string& folder : all) {
    const auto scan = catalogue->addFolder(folder, read);
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
  return report;
}

}  // namespace fyd::catalogue
