// The list of all sessions, in SQLite on this computer or in PostgreSQL for several stations.
//
// The recordings are the truth, the catalogue an index that can be built again from them; only notes and tags changed
// here stand nowhere else. Nothing here ever deletes or changes a recording. Every change is one transaction.
//
// All calls may wait for a disk or a server (a locked SQLite file 5 s, a silent server 10 s): never from the haptic
// loop. A Catalogue belongs to one thread at a time; any number of them and of processes may be open at once.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/session/catalogue_types.h"

namespace fyd::session {

class CatalogueDatabase;

/// Reads what the catalogue needs from a recording's file.
using EntryReader = std::function<Result<CatalogueEntry>(const std::string& path)>;
/// Through Recording::open; `station` is this host.
[[nodiscard]] Result<CatalogueEntry> readCatalogueEntry(const std::string& path);

struct FileChange {
  enum class Kind : std::uint8_t { moved, missing, changed, replaced, returned };
  Kind kind = Kind::missing;
  std::string id;
  std::string old_path;
  std::string new_path;  ///< moved: where it is now
};
[[nodiscard]] const char* toString(FileChange::Kind kind);

struct ScanReport {
  std::size_t added = 0;
  std::size_t known = 0;
  std::vector<std::string> copies;  ///< files of a recording that stands elsewhere too; the first one stays
  std::vector<Message> unreadable;  ///< "path: why"
};

/// What became of entries that had waited for this catalogue.
struct PendingReport {
  std::size_t delivered = 0;
  std::size_t waiting = 0;
  Message problem;  ///< why some still wait
};

class Catalogue {
 public:
  /// Opens or makes it, brings its tables up to date, and delivers entries that had to wait.
  /// @return an error that names the catalogue: unreachable, locked (and by whom), damaged, newer than this program
  [[nodiscard]] static Result<Catalogue> open(const std::string& word);
  /// An empty one that ends with this object; for searching a folder's recordings without writing anything.
  [[nodiscard]] static Result<Catalogue> inMemory();
  Catalogue(Catalogue&&) noexcept;
  Catalogue& operator=(Catalogue&&) noexcept;
  ~Catalogue();

  [[nodiscard]] const std::string& name() const;  ///< for messages; holds no secret
  [[nodiscard]] const PendingReport& pending() const { return pending_; }

  /// Puts the entry in. One with the same id gets the new facts of the file; its station, notes and tags stay.
  [[nodiscard]] Result<void> add(const CatalogueEntry& entry);
  /// All of them or none.
  [[nodiscard]] Result<void> add(std::span<const CatalogueEntry> entries);
  /// Replaces everything of the entry with this id; an error when there is none.
  [[nodiscard]] Result<void> update(const CatalogueEntry& entry);

  [[nodiscard]] Result<std::vector<CatalogueEntry>> search(const SessionFilter& filter) const;
  /// How many `filter` finds, its limit and offset aside.
  [[nodiscard]] Result<std::size_t> count(const SessionFilter& filter) const;
  /// @param id whole, or its first digits (4 or more) when only one entry begins so
  [[nodiscard]] Result<CatalogueEntry> get(const std::string& id) const;

  [[nodiscard]] Result<void> setNotes(const std::string& id, const std::string& notes);
  /// In place of those it had; the same tag twice counts once.
  [[nodiscard]] Result<void> setTags(const std::string& id, const std::vector<std::string>& tags);
  /// Its file was moved there by this program.
  [[nodiscard]] Result<void> setPath(const std::string& id, const std::string& path);
  /// Forgets the entry; the file stays.
  [[nodiscard]] Result<void> remove(const std::string& id);

  /// Remembers the folder and puts in every recording (.h5, .h5.partial) below it.
  [[nodiscard]] Result<ScanReport> addFolder(const std::string& path, const EntryReader& read = readCatalogueEntry);
  /// This station's.
  [[nodiscard]] Result<std::vector<std::string>> folders() const;

  /// Looks at this station's files; those that are gone are sought by id in the known folders and the entries' own.
  [[nodiscard]] Result<std::vector<FileChange>> checkFiles(const EntryReader& read = readCatalogueEntry);

 private:
  explicit Catalogue(std::unique_ptr<CatalogueDatabase> database);
  [[nodiscard]] Result<void> markFile(const std::string& id, FileState state);
  std::unique_ptr<CatalogueDatabase> database_;
  PendingReport pending_;
};

/// Puts a closed recording into the catalogue. When that fails for the catalogue's sake, the entry waits in
/// pendingPath() and goes in when the catalogue is next opened: the error says so. The recording is safe either way.
[[nodiscard]] Result<void> catalogueRecording(const std::string& catalogue_word, const std::string& recording_path);
/// The same with an entry at hand.
[[nodiscard]] Result<void> deliverEntry(const std::string& catalogue_word, const CatalogueEntry& entry);

struct RebuildReport {
  std::string moved_aside;  ///< where the damaged file went; empty: it was not damaged
  std::size_t rescued = 0;  ///< entries whose notes and tags could be read from it
  std::vector<std::string> folders;
  ScanReport scan;
};
/// Builds the catalogue again from the recordings in its folders and in `folders`. A damaged SQLite file is moved
/// aside, never deleted; what can still be read from it is taken over.
[[nodiscard]] Result<RebuildReport> rebuildCatalogue(const std::string& word, const std::vector<std::string>& folders,
                                                     const EntryReader& read = readCatalogueEntry);

}  // namespace fyd::session
