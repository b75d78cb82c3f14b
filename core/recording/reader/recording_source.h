// The file under a recording that is being read.
#pragma once

#include <memory>
#include <string>

#include "core/recording/file/recording_place.h"
#include "core/recording/file/recording_storage.h"

namespace fyd::recording {

/// @throws RecordingFailure: missing, unreadable, not a file
[[nodiscard]] bool isBeingRecorded(const std::string& path);

/// Calls `open` with the name that exists, and once more when that fails because the recorder ended meanwhile: the file
/// then has another name, or holds a partial write that is complete in the journal only.
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
  [[nodiscard]] bool recorderRuns() const;
  /// A recorder was running when the file was opened.
  [[nodiscard]] bool growing() const { return growing_; }
  /// The journal of an ended recorder is read here, but not yet applied to the file: other programs do not see it.
  [[nodiscard]] bool journalPending() const { return disk_->foundJournal(); }
  [[nodiscard]] std::uint64_t bytes() const;
  /// At its end: the closed file was cut short, as by a copy that broke off.
  [[nodiscard]] std::uint64_t missingBytes() const { return disk_->missingBytes(); }
  /// Its recorder ran when the file was opened and has ended since: its journal has not been read.
  [[nodiscard]] bool recorderEnded() const { return growing_ && !recorderRuns(); }

 private:
  RecordingSource(int descriptor, std::string path);

  Descriptor descriptor_;
  std::string path_;
  bool growing_ = false;
  std::shared_ptr<JournaledFile> disk_;
  Handle file_;
};

}  // namespace fyd::recording
