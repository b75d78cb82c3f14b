// The file under a recording that is being read.
#pragma once

#include <memory>
#include <string>

#include "core/session/recording_storage.h"

namespace fyd::session {

/// `path`, or the unfinished file beside it when only that is there.
[[nodiscard]] std::string existingName(const std::string& path);

class RecordingSource {
 public:
  /// @throws RecordingFailure: missing, unreadable, no HDF5 file
  explicit RecordingSource(const std::string& path);
  RecordingSource(const RecordingSource&) = delete;
  RecordingSource& operator=(const RecordingSource&) = delete;

  [[nodiscard]] hid_t file() const { return file_.id(); }
  void close() { file_.reset(); }
  [[nodiscard]] bool recorderLives() const;
  [[nodiscard]] std::uint64_t bytes() const;
  /// Opened while a recorder lived: what that recorder may leave in the journal is not seen.
  [[nodiscard]] bool openedGrowing() const { return growing_; }

 private:
  Descriptor descriptor_;
  bool growing_;
  std::unique_ptr<JournaledFile> disk_;
  Handle file_;
};

}  // namespace fyd::session
