// The catalogue of all recordings, in SQLite on this computer or in PostgreSQL for several stations.
//
// The catalogue is an index that can be rebuilt from the recordings; only notes and tags changed here are stored
// nowhere else. Nothing here deletes or changes a recording. Every change is one transaction.
//
// All calls may wait for a disk or a server (catalogue_address.cpp says for how long, and for what without end): never
// from the haptic loop. A Catalogue belongs to one thread at a time; any number of them and of processes may be open at
// once.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/catalogue/catalogue_entry.h"
#include "core/catalogue/catalogue_pending.h"
#include "core/catalogue/catalogue_types.h"

namespace fyd::catalogue {

class CatalogueDatabase;

struct FileChange {
  enum class Kind : std::uint8_t {
    moved,
    missing,
    changed,
    replaced,
    returned,
    unreadable  ///< whether the recording is still there cannot be found out: its entry stays as it was
  };
  Kind kind = Kind::missing;
  std::string id;
  std::string old_path;
  std::string new_path;  ///< moved: where it is now
  Message problem;       ///< unreadable: why
};
[[nodiscard]] const char* toString(FileChange::Kind kind);

struct ScanReport {
  std::size_t added = 0;
  std::size_t known = 0;
  std::vector<std::string> copies;  ///< further files of a recording that has an entry already, which stays
  std::vector<Message> unreadable;  ///< "path: why", of files and of folders
};

class Catalogue {
 public:
  /// Opens or creates it, brings its tables up to date, and delivers waiting entries (catalogue_pending.h).
  /// @return an error that names the catalogue: unreachable, locked (and by whom), damaged, newer than this program
  [[nodiscard]] static Result<Catalogue> open(const std::string& word);
  /// An empty one in memory; for searching a folder's recordings without writing anything.
  [[nodiscard]] static Result<Catalogue> inMemory();
  Catalogue(Catalogue&&) noexcept;
  Catalogue& operator=(Catalogue&&) noexcept;
  ~Catalogue();

  [[nodiscard]] const std::string& name() const;  ///< for messages; holds no secret
  [[nodiscard]] const PendingReport& pending() const { return pending_; }

  /// Adds the entry. An existing one with the same id gets the new facts of the file, and with a new path the station
  /// that sees it there; its notes and tags stay.
  [[nodiscard]] Result<void> add(const CatalogueEntry& entry);
  /// The same, and this station looks after its file from now on: for a file that was named here.
  [[nodiscard]] Result<void> addAsOwn(const CatalogueEntry& entry);
  /// All of them or none.
  [[nodiscard]] Result<void> add(std::span<const CatalogueEntry> entries);
  /// Replaces everything of the entry with this id; an error when there is none.
  [[nodiscard]] Result<void> update(const CatalogueEntry& entry);

  [[nodiscard]] Result<std::vector<CatalogueEntry>> search(const SessionFilter& filter) const;
  /// How many entries `filter` finds, without its limit and offset.
  [[nodiscard]] Result<std::size_t> count(const SessionFilter& filter) const;
  /// @param id complete, or its first characters (4 or more) if only one entry begins with them
  [[nodiscard]] Result<CatalogueEntry> get(const std::string& id) const;

  [[nodiscard]] Result<void> setNotes(const std::string& id, const std::string& notes);
  /// Replaces the entry's tags; duplicates are merged.
  [[nodiscard]] Result<void> setTags(const std::string& id, const std::vector<std::string>& tags);
  /// For a file that this program has moved.
  [[nodiscard]] Result<void> setPath(const std::string& id, const std::string& path);
  /// Removes the entry; the file stays.
  [[nodiscard]] Result<void> remove(const std::string& id);

  /// Stores the folder as known and adds every recording (.h5, .h5.partial) below it.
  [[nodiscard]] Result<ScanReport> addFolder(const std::string& path, const EntryReader& read = readCatalogueEntry);
  /// This station's known folders.
  [[nodiscard]] Result<std::vector<std::string>> folders() const;

  /// Checks this station's files; missing ones are searched by id in the known folders and the entries' own folders.
  [[nodiscard]] Result<std::vector<FileChange>> checkFiles(const EntryReader& read = readCatalogueEntry);

 private:
  explicit Catalogue(std::unique_ptr<CatalogueDatabase> database);
  [[nodiscard]] Result<void> markFile(const std::string& id, FileState state);
  std::unique_ptr<CatalogueDatabase> database_;
  PendingReport pending_;
};

}  // namespace fyd::catalogue
