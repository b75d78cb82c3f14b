// Writes one recording: HDF5 in SWMR mode, made so that whatever happens, what was committed can be read.
//
//   FILE.partial        while the recording grows (and after a crash, until `recover`); same folder
//   FILE                after `close`: whole
//
// Fixed datasets are made before writing begins; then again and again: rows and a commit row with the row counts and a
// CRC32C of each dataset's new block → flush → sync, all or nothing. A reader trusts committed rows only.
// The layout stands in recording_format.h and in resources/manual/recording-format.md.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/base/error.h"
#include "core/recording/recording_types.h"
#include "core/recording/step_record.h"

namespace fyd::recording {

class DiskCalls;

/// Used by one thread (the recorder's).
class RecordingWriter {
 public:
  /// @return an error when the folder cannot be written, is on a network share, or FILE or FILE.partial exists
  [[nodiscard]] static Result<std::unique_ptr<RecordingWriter>> create(const std::string& path,
                                                                       const RecordingHeader& header);
  virtual ~RecordingWriter() = default;  ///< without `close`: leaves FILE.partial as a crash would

  /// Every step in order; a jump of `telemetry.step` is a gap. Commits by itself after each kBlockSteps steps.
  /// @return an error when writing failed; the recording is then over, what was committed is safe
  [[nodiscard]] virtual Result<void> append(const StepRecord& record) = 0;
  /// These go with the next commit.
  [[nodiscard]] virtual Result<void> append(const EncodedPicture& picture) = 0;
  [[nodiscard]] virtual Result<void> append(const Note& note) = 0;
  [[nodiscard]] virtual Result<void> append(const LinkRow& row) = 0;
  /// Steps the ring could not take; they are `lost` in the file's /commits.
  virtual void countLost(std::uint64_t steps) = 0;
  /// Commits what there is now, a short block too.
  [[nodiscard]] virtual Result<void> commit() = 0;
  /// Commits, marks the file whole, syncs it and gives it its name.
  [[nodiscard]] virtual Result<void> close() = 0;

  [[nodiscard]] virtual std::uint64_t committedSteps() const = 0;
  [[nodiscard]] virtual std::uint64_t bytes() const = 0;  ///< on disk
  /// Before `close`: FILE.partial is there still and as long as it was written; another program may do anything to it.
  [[nodiscard]] virtual bool safe() const = 0;
  [[nodiscard]] virtual Result<void> checkSafe() const = 0;  ///< in words
};

/// RecordingWriter::create with other disk calls: for tests that simulate disk errors.
[[nodiscard]] Result<std::unique_ptr<RecordingWriter>> createRecording(const std::string& path,
                                                                       const RecordingHeader& header,
                                                                       std::shared_ptr<DiskCalls> calls);

}  // namespace fyd::recording
