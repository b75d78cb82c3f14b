// The file under a recording that is being read.
#pragma once

#include <string>

#include "core/session/recording_hdf5.h"

namespace fyd::session {

/// `path`, or the unfinished file beside it when only that is there.
[[nodiscard]] std::string existingName(const std::string& path);

class RecordingSource {
 public:
  /// @throws RecordingFailure: missing, unreadable, no HDF5 file
  explicit RecordingSource(const std::string& path);
  RecordingSource(const RecordingSource&) = delete;
  RecordingSource& operator=(const RecordingSource&) = delete;
  ~RecordingSource() { close(); }
  void close();

  [[nodiscard]] hid_t file() const { return file_.id(); }
  [[nodiscard]] bool recorderLives() const;
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  int descriptor_ = -1;
  Handle file_;
};

}  // namespace fyd::session
