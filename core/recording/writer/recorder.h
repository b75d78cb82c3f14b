// The recorder's thread: always keeps the last seconds in memory; a recording begins with them.
//
//   haptic loop ─▶ ring of packed steps ─▶ ┐                       ┌ pre-trigger (memory, 10 s by default)
//   camera thread ─▶ queue of pictures ──▶ ├─ recorder's thread ─▶ ┤
//   operator ─▶ notes ───────────────────▶ ┘                       └ RecordingWriter (disk)
//
// A second Pipeline follows the recorded inputs on this thread; its state at the pre-trigger's first row goes into the
// file, so that a replay can start in the middle of a session, and the haptic loop spends no time on snapshots. It also
// checks continuously that the recorded inputs give the recorded outputs; each step that differs is counted.
#pragma once

#include <memory>
#include <string>

#include "core/base/error.h"
#include "core/pipeline/local_model.h"
#include "core/pipeline/parameters.h"
#include "core/recording/packed_step.h"
#include "core/recording/recording_types.h"
#include "core/recording/writer/recorder_options.h"
#include "core/recording/writer/recorder_types.h"

namespace fyd::recording {

class DiskCalls;

class Recorder {
 public:
  Recorder(const RecorderOptions& options, const pipeline::Parameters& step, const pipeline::LocalModel& local,
           StationDescription description, StationSource source);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  ~Recorder();  ///< closes the recording

  /// For tests, which simulate disk errors; before `start`.
  void writeThrough(std::shared_ptr<DiskCalls> disk);
  void start();     ///< the thread; before the haptic loop
  void shutDown();  ///< after the haptic loop: closes the recording, joins

  /// From the haptic loop only: never waits nor allocates; a full ring is counted.
  void push(const StepView& step) noexcept;
  /// From the camera thread.
  void offerPicture(const cv::Mat& picture, const cv::Rect& region, const sensing::FingerDetection& finger,
                    Instant taken, std::uint64_t number);

  // From the operator's thread:
  /// @return an error at once when the file cannot be made or one is being recorded; then nothing changes
  [[nodiscard]] Result<void> begin(const RecordingRequest& request);
  /// Closes the file. @return its error, if any
  [[nodiscard]] Result<void> end();
  /// @return an error that names the text when nothing is being recorded: it is not kept
  [[nodiscard]] Result<void> note(NoteKind kind, const std::string& text);
  [[nodiscard]] RecorderStatus status() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fyd::recording
