// The file under a recording that is being written: HDF5 in SWMR mode over a JournaledFile, and `persist`, after
// which everything flushed survives a power cut.
#pragma once

#include <memory>
#include <string>

#include "core/recording/file/recording_disk.h"
#include "core/recording/file/recording_hdf5.h"

namespace fyd::recording {

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
  /// Opens, for repair, a file that an ended recorder left unfinished, and applies its journal.
  RecordingStorage(const LeftBehind& left_behind, std::shared_ptr<DiskCalls> calls);
  RecordingStorage(const RecordingStorage&) = delete;
  RecordingStorage& operator=(const RecordingStorage&) = delete;
  /// Without `close`: leaves the file as the last commit made it.
  ~RecordingStorage();

  [[nodiscard]] hid_t file() const { return file_.id(); }
  void startSwmr();
  /// Writes out what HDF5 still buffers; under the HDF5 lock.
  void flush();
  /// Commits, all or nothing, what was flushed since the last call; waits for the disk, needs no lock.
  void persist();
  /// From now on nothing is written to the file.
  void abandon() { disk_->abandon(); }
  /// Flushes and closes the HDF5 file; the caller has closed its tables. Then `dropJournal`.
  void close();
  /// Persists, and leaves nothing for a reader to apply.
  void dropJournal();
  void finish() {
    close();
    dropJournal();
  }
  [[nodiscard]] std::uint64_t bytes() const { return disk_->size(); }
  /// false: no file or another one has this name, or it was made shorter than it was written.
  [[nodiscard]] bool isStill(const std::string& path) const;

 private:
  void take(hid_t opened_file);
  Descriptor descriptor_;
  std::shared_ptr<JournaledFile> disk_;
  Handle file_;
};

}  // namespace fyd::recording
