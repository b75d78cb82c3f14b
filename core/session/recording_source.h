// The file under a recording that is being read.
#pragma once

#include <memory>
#include <string>

#include "core/session/recording_storage.h"

namespace fyd::session {

/// `path`, or the unfinished file beside it when only that is there.
[[nodiscard]] std::string existingName(const std::string& path);

/// @throws RecordingFailure: missing, unreadable, not a file
[[nodiscard]] bool isBeingRecorded(const std::string& path);

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
  /// Its recorder lived when it was opened and is gone now: what it left in the journal has not been seen.
  [[nodiscard]] bool outlivedRecorder() const { return growing_ && !recorderLives(); }
  /// Opens the same file anew; the caller has closed its tables.
  void reopen();

 private:
  Descriptor descriptor_;
  std::string path_;
  bool growing_ = false;
  std::shared_ptr<JournaledFile> disk_;
  Handle file_;
};

}  // namespace fyd::session
