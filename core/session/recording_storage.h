// The file under a recording that is being written: HDF5 in SWMR mode, and `commit`, after which everything lasts.
#pragma once

#include <memory>
#include <string>

#include "core/session/recording_hdf5.h"

namespace fyd::session {

class RecordingStorage {
 public:
  /// Makes FILE.partial, which must not exist. @throws RecordingFailure, as all of these do
  explicit RecordingStorage(const std::string& partial);
  RecordingStorage(const RecordingStorage&) = delete;
  RecordingStorage& operator=(const RecordingStorage&) = delete;
  /// Leaves the file as the last commit made it.
  ~RecordingStorage();

  [[nodiscard]] hid_t file() const { return file_.id(); }
  void startSwmr();
  /// Flushes HDF5's caches and waits until the disk has everything.
  void commit();
  /// Ends HDF5's part; the caller has closed its tables.
  void close();
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  int descriptor_ = -1;
  Handle file_;
};

}  // namespace fyd::session
