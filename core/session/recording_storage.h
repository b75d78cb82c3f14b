// The file under a recording that is being written: HDF5 in SWMR mode over a JournaledFile, and `commit`, after which
// everything lasts.
#pragma once

#include <memory>
#include <string>

#include "core/session/recording_disk.h"
#include "core/session/recording_hdf5.h"

namespace fyd::session {

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor();
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

struct LeftBehind {
  std::string path;
};

class RecordingStorage {
 public:
  /// Makes FILE.partial, which must not exist. @throws RecordingFailure, as all of these do
  RecordingStorage(const std::string& partial, std::shared_ptr<DiskCalls> calls);
  /// Opens a file a gone recorder left, to mend it, and applies its journal.
  RecordingStorage(const LeftBehind& left_behind, std::shared_ptr<DiskCalls> calls);
  RecordingStorage(const RecordingStorage&) = delete;
  RecordingStorage& operator=(const RecordingStorage&) = delete;
  /// Without `close`: leaves the file as the last commit made it.
  ~RecordingStorage();

  [[nodiscard]] hid_t file() const { return file_.id(); }
  void startSwmr();
  /// Gives the disk what HDF5 still keeps; under the HDF5 lock.
  void flush();
  /// All or nothing of what was flushed since the last time lasts; waits for the disk, needs no lock.
  void persist();
  /// From now on nothing reaches the file.
  void abandon() { disk_->abandon(); }
  /// Flushes and ends HDF5's part; the caller has closed its tables. Then `dropJournal`.
  void close();
  /// Persists, and leaves nothing for a reader to apply.
  void dropJournal();
  /// `close` and what follows it.
  void finish() {
    close();
    dropJournal();
  }
  [[nodiscard]] std::uint64_t bytes() const { return disk_->size(); }

 private:
  void take(hid_t opened_file);
  Descriptor descriptor_;
  std::shared_ptr<JournaledFile> disk_;
  Handle file_;
};

}  // namespace fyd::session
