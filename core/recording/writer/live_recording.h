// One recording while it is written: its file, progress and status.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "core/recording/recording_types.h"
#include "core/recording/writer/disk_space.h"
#include "core/recording/writer/picture_history.h"
#include "core/recording/writer/recorder_options.h"
#include "core/recording/writer/recorder_types.h"
#include "core/recording/writer/recording_writer.h"
#include "core/recording/writer/step_follower.h"

namespace fyd::recording {

class LiveRecording {
 public:
  /// What is written; outlives it.
  struct Sources {
    StepFollower& steps;
    PictureHistory& pictures;
    const StationSource& station;
    std::uint64_t lost_before = 0;  ///< of `steps`, when the recording's first step was chosen
  };

  /// @param header without id and times
  /// @return an error when the disk has too little room or the file cannot be made
  [[nodiscard]] static Result<std::unique_ptr<LiveRecording>> open(const std::string& path, RecordingHeader header,
                                                                   const RecorderOptions& options, Sources sources,
                                                                   std::shared_ptr<DiskCalls> disk);
  LiveRecording(const LiveRecording&) = delete;
  LiveRecording& operator=(const LiveRecording&) = delete;
  ~LiveRecording();  ///< leaves the file as it is

  /// Writes what waits: no more than a few steps and pictures at a time, so that a start does not starve other threads.
  [[nodiscard]] Result<void> write(const std::vector<Note>& notes);
  /// Once a second: writes the link's row, measures the file's growth and looks whether the file is there still.
  /// @return false when the disk has too little room left
  [[nodiscard]] Result<bool> everySecond(Instant now);
  /// Writes all that waits, and closes the file: it is whole when this returns without an error.
  [[nodiscard]] Result<void> close(const std::vector<Note>& notes);

  // Two turns for each commit: a thread that wakes more often has cold caches each time, and takes half as long again.
  static constexpr std::chrono::milliseconds kLongestTurn{125};
  /// How long until the next commit is due, or the next portion while more waits than was written.
  [[nodiscard]] std::chrono::milliseconds untilNextTurn() const;
  /// Fills in the figures of this recording; state and problem are set by the recorder.
  void fillIn(RecorderStatus& status) const;
  /// The recording's time of its last committed step.
  [[nodiscard]] double committed_s() const { return toSeconds(committed_until_ - header_.started); }
  [[nodiscard]] bool safe() const { return writer_->safe(); }

 private:
  LiveRecording(std::string path, RecordingHeader header, const RecorderOptions& options, Sources sources,
                std::unique_ptr<RecordingWriter> writer);
  [[nodiscard]] Result<void> write(std::size_t most_steps, std::size_t most_pictures, const std::vector<Note>& notes);
  [[nodiscard]] bool wholeIsDue(const HeldPicture& picture);

  const std::string path_;
  const RecordingHeader header_;
  const RecorderOptions options_;
  Sources sources_;
  std::unique_ptr<RecordingWriter> writer_;
  StepRecord record_;  // scratch
  Instant written_until_{};
  Instant committed_until_{};
  Instant newest_whole_{};           // picture
  std::uint64_t without_whole_ = 0;  // pictures since it
  bool behind_ = false;              // more steps wait than may be written in one turn
  std::uint64_t samples_ = 0;
  std::uint64_t pictures_ = 0;
  std::uint64_t lost_told_ = 0;
  GrowthRate growth_;
  double minutes_left_ = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> commits_ms_;
  Instant next_second_{};
};

}  // namespace fyd::recording
