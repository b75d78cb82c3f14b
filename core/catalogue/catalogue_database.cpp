#include "core/catalogue/catalogue_database.h"

#include <soci/postgresql/soci-postgresql.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>

#include "core/base/system_reason.h"
#include "core/base/write_target.h"
#include "core/recording/file/recording_place.h"

namespace fyd::catalogue {
namespace {

constexpr int kBusy_ms = 5000;

Result<void> prepareFolder(const std::string& path) {
  namespace fs = std::filesystem;
  if (path == kInMemory) return {};
  const fs::path folder = fs::path(path).parent_path();
  std::error_code error;
  if (!fs::exists(folder, error)) {
    fs::create_directories(folder, error);
    if (error) return fail("{}: the folder cannot be made: {}", path, systemReason(error));
    fs::permissions(folder, fs::perms::owner_all, error);  // it holds subjects' codes: no access for others
  }
  if (!fs::is_directory(folder, error)) return fail("{}: {} is no folder", path, folder.native());
  const auto target = writeTargetOf(path);
  if (!target) return tl::unexpected(target.error());
  // SQLite's write-ahead log needs memory shared by processes of one computer; it lies where a link leads to.
  if (recording::networkShareOf(fs::path(target->path).parent_path())) {
    return fail("{}: on a network share, where SQLite would be damaged; use a local path, or postgresql:…", path);
  }
  return {};
}

std::string sqliteOptions(const std::string& path) { return fmt::format("dbname=\"{}\"", path); }

int sqliteCode(const std::exception& error) {
  const auto* sqlite = dynamic_cast<const soci::sqlite3_soci_error*>(&error);
  return sqlite ? sqlite->result() & 0xFF : SQLITE_OK;
}

/// The error's message on one line: libpq writes several, and SOCI adds the statement with its values.
std::string oneLine(const std::exception& error) {
  const auto* soci_error = dynamic_cast<const soci::soci_error*>(&error);
  std::string text = soci_error ? soci_error->get_error_message() : error.what();
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  std::string out;
  for (const char c : text) {
    const bool space = c == '\n' || c == '\t' || c == ' ';
    if (!space) out += c;
    if (space && !out.ends_with(' ')) out += ' ';
  }
  return out;
}

/// Whether the database refused what one statement carries, by PostgreSQL's classes of errors: data, integrity, limits
/// of the program.
bool isAboutValues(const std::exception& error) {
  if (const auto* postgresql = dynamic_cast<const soci::postgresql_soci_error*>(&error)) {
    const std::string kind = postgresql->sqlstate().substr(0, 2);
    return kind == "22" || kind == "23" || kind == "54";
  }
  const int code = sqliteCode(error);
  return code == SQLITE_CONSTRAINT || code == SQLITE_TOOBIG || code == SQLITE_MISMATCH;
}

/// Whether a damaged file is, or was, a catalogue: by its list of tables where that can still be read; else the first
/// page tells the tables' names in plain text, also when its beginning is damaged.
bool wasCatalogue(const std::string& path) {
  try {
    soci::session sqlite(soci::sqlite3, sqliteOptions(path));
    if (isOfAnother(sqlite)) return false;
    long long ours = 0;
    sqlite << "SELECT count(*) FROM sqlite_master WHERE name = 'catalogue_version'", soci::into(ours);
    if (ours > 0) return true;
  } catch (const std::exception&) {  // the list is damaged, too
  }
  constexpr std::size_t kLargestPage = 65'536;
  std::string page(kLargestPage, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(page.data(), static_cast<std::streamsize>(page.size()));
  page.resize(static_cast<std::size_t>(file.gcount()));
  return page.find("CREATE TABLE catalogue_version") != std::string::npos;
}

tl::unexpected<Error> noCatalogue(const std::string& path) {
  return fail("{}: is no catalogue, and nothing in it shows that it was one; choose another file, or move it away",
              path);
}

}  // namespace

CatalogueDatabase::Transaction::~Transaction() {
  if (!open_) return;
  try {
    session_ << "ROLLBACK";
  } catch (const std::exception&) {  // the server is gone, and with it the transaction
  }
}

void CatalogueDatabase::Transaction::keep() {
  session_ << "COMMIT";
  open_ = false;
}

void CatalogueDatabase::connect() {
  session_.close();
  if (word_.kind == CatalogueAddress::Kind::postgresql) {
    session_.open(soci::postgresql, word_.target);
  } else {
    session_.open(soci::sqlite3, sqliteOptions(word_.target));
    std::string ignored;
    session_ << "PRAGMA busy_timeout = " << kBusy_ms, soci::into(ignored);
    session_ << "PRAGMA foreign_keys = ON";
    if (isOfAnother(session_)) return;  // nothing of it is changed; prepareSchema refuses it
    // Changing to the write-ahead log ignores the time-out when two processes make the file at the same moment.
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::milliseconds(kBusy_ms);
    for (;;) {
      try {
        session_ << "PRAGMA journal_mode = WAL", soci::into(ignored);
        break;
      } catch (const soci::sqlite3_soci_error& error) {
        if (sqliteCode(error) != SQLITE_BUSY || std::chrono::steady_clock::now() > give_up) throw;
        sqlite_api::sqlite3_sleep(20);
      }
    }
    session_ << "PRAGMA synchronous = FULL";  // a power cut loses no committed transaction
  }
  lost_ = false;
}

Error CatalogueDatabase::explained(const std::exception& error) {
  const std::string what = oneLine(error);
  refused_values_ = isAboutValues(error);
  if (word_.kind == CatalogueAddress::Kind::postgresql) {
    lost_ = true;  // connect again, as the old connection may be dead
    return {about(word_.name, verbatim(what))};
  }
  const std::string& path = word_.target;
  switch (sqliteCode(error)) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED: {
      const std::string holders = holdersOf(path);
      return {say("{}: locked by another program for more than {} s; it is open in {}", path, kBusy_ms / 1000,
                  holders.empty() ? say("no program that this user can see") : verbatim(holders))};
    }
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB: {
      if (path == pendingPath()) {
        return {
            say("{}: what waits for catalogues is damaged ({}); the recordings are not touched by that. Move the file "
                "away, then `fyd session list --rebuild FOLDER` for each catalogue reads the recordings again",
                path, verbatim(what))};
      }
      if (!wasCatalogue(path)) return noCatalogue(path).value();
      return {
          say("{}: the catalogue is damaged ({}); the recordings are not touched by that. `fyd session list "
              "--rebuild FOLDER{}` moves the file aside and reads the recordings again",
              path, verbatim(what), isDefault(word_) ? "" : fmt::format(" --catalogue 'sqlite:{}'", path))};
    }
    case SQLITE_FULL: return {say("{}: the disk is full; nothing of this change was kept", path)};
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
      return {say("{}: cannot be written or opened ({}); check the folder's permissions", path, verbatim(what))};
    default: return {about(path, verbatim(what))};
  }
}

Result<std::unique_ptr<CatalogueDatabase>> CatalogueDatabase::open(const CatalogueAddress& word, SchemaSteps schema) {
  if (word.kind == CatalogueAddress::Kind::none) return fail("no catalogue was chosen");
  if (word.kind == CatalogueAddress::Kind::sqlite) {
    if (auto ok = prepareFolder(word.target); !ok) return tl::unexpected(ok.error());
  }
  std::unique_ptr<CatalogueDatabase> database(new CatalogueDatabase(word));
  try {
    database->connect();
    if (word.kind == CatalogueAddress::Kind::sqlite) {
      std::string answer;
      database->session_ << "PRAGMA quick_check(1)", soci::into(answer);
      if (answer != "ok") throw soci::sqlite3_soci_error(answer, SQLITE_CORRUPT);
    }
  } catch (const std::exception& error) {
    return tl::unexpected(database->explained(error));
  }
  if (auto ok = database->prepareSchema(schema); !ok) return tl::unexpected(ok.error());
  return database;
}

Result<bool> isDamaged(const std::string& path) {
  std::error_code error;
  const bool there = std::filesystem::exists(path, error);
  if (error) return fail(about(path, systemReason(error)));
  if (!there) return false;
  if (const auto target = writeTargetOf(path); !target) return tl::unexpected(target.error());
  try {
    soci::session session(soci::sqlite3, sqliteOptions(path));
    std::string answer;
    session << "PRAGMA busy_timeout = " << kBusy_ms, soci::into(answer);
    session << "PRAGMA quick_check(1)", soci::into(answer);
    if (answer == "ok") return false;
  } catch (const std::exception& problem) {
    const int code = sqliteCode(problem);
    if (code != SQLITE_CORRUPT && code != SQLITE_NOTADB) return fail(about(path, verbatim(oneLine(problem))));
  }
  if (!wasCatalogue(path)) return noCatalogue(path);  // another program's is not ours to move, damaged or not
  return true;
}

void BoundStatement::bind(const std::string& name, std::string value) {
  auto& kept = texts_.emplace_back(name, std::move(value));
  statement_.exchange(soci::use(kept.second, kept.first));
}

void BoundStatement::bind(const std::string& name, long long value) {
  auto& kept = numbers_.emplace_back(name, value);
  statement_.exchange(soci::use(kept.second, kept.first));
}

void BoundStatement::execute(const std::string& sql) {
  statement_.alloc();
  statement_.prepare(sql);
  statement_.define_and_bind();
  statement_.execute();
}

// From /proc.
std::string holdersOf(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path wanted = fs::weakly_canonical(path, error);
  std::string out;
  for (const fs::directory_entry& process : fs::directory_iterator("/proc", error)) {
    const std::string number = process.path().filename();
    if (!std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; })) continue;
    std::error_code unseen;  // another user's, or just ended
    bool holds = false;
    fs::directory_iterator descriptor(process.path() / "fd", unseen);
    for (; !unseen && descriptor != fs::directory_iterator(); descriptor.increment(unseen)) {
      std::error_code closed;
      if (fs::read_symlink(descriptor->path(), closed) == wanted) holds = true;
    }
    if (!holds) continue;
    std::string command;
    std::getline(std::ifstream(process.path() / "comm") >> std::ws, command);
    out += fmt::format("{}{} (process {})", out.empty() ? "" : ", ", command, number);
  }
  return out;
}

}  // namespace fyd::catalogue
