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

/// Opens a recording as `open` does with the name that is there. When that fails because its recorder ended meanwhile,
/// and so left another name, or half of a write that stands whole in its journal only, once more.
template <class Open>
auto openedAsItIs(const std::string& path, Open&& open) -> Result<decltype(open(path))> {
  for (int attempt = 1;; ++attempt) {
    const std::string found = existingName(path);
    const bool growing = guarded(found, [&] { return isBeingRecorded(found); }).value_or(false);
    auto opened = guarded(found, [&] { return open(found); });
    if (opened || attempt == 2 || (!growing && existingName(path) == found)) return opened;
  }
}

class RecordingSource {
 public:
  /// @throws RecordingFailure: missing, unreadable, no HDF5 file
  explicit RecordingSource(const std::string& path);
  RecordingSource(const RecordingSource&) = delete;
  RecordingSource& operator=(const RecordingSource&) = delete;

  /// The same file opened anew, under whatever name it has by now. @throws as the constructor
  [[nodiscard]] std::unique_ptr<RecordingSource> again() const;
  [[nodiscard]] hid_t file() const { return file_.id(); }
  void close() { file_.reset(); }
  [[nodiscard]] bool recorderLives() const;
  /// A recorder lived when it was opened.
  [[nodiscard]] bool growing() const { return growing_; }
  /// What a gone recorder's journal holds is seen here, but not by other programs: it has yet to be applied.
  [[nodiscard]] bool journalWaits() const { return disk_->foundJournal(); }
  [[nodiscard]] std::uint64_t bytes() const;
  /// Its recorder lived when it was opened and is gone now: what it left in the journal has not been seen.
  [[nodiscard]] bool outlivedRecorder() const { return growing_ && !recorderLives(); }

 private:
  RecordingSource(int descriptor, std::string path);

  Descriptor descriptor_;
  std::string path_;
  bool growing_ = false;
  std::shared_ptr<JournaledFile> disk_;
  Handle file_;
};

}  // namespace fyd::session
