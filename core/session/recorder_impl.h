// What a Recorder holds. Read by recorder.cpp (the other threads' side) and recorder_thread.cpp only.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "core/base/ring.h"
#include "core/pipeline/pipeline.h"
#include "core/session/disk_space.h"
#include "core/session/picture_history.h"
#include "core/session/recorder.h"
#include "core/session/recording_writer_on_disk.h"
#include "core/session/step_history.h"

namespace fyd::session {

/// At least 2 s of steps whose every list is full, 9 s of usual ones.
inline constexpr std::size_t kRingBytes = 2000 * kLargestPackedStep;

/// Processor time of the calling thread.
[[nodiscard]] double threadWork_s();

/// What `begin` and `end` wait for.
struct RecorderAnswer {
  bool done = false;
  bool abandoned = false;  ///< nobody waits any more: what was begun is undone
  Result<void> result;
};

struct Recorder::Impl {
  Impl(const RecorderOptions& chosen, const pipeline::Parameters& step, const pipeline::LocalModel& felt,
       StationDescription words, StationSource asked)
      : options(chosen), description(std::move(words)), source(std::move(asked)), local(felt), shadow(step, felt) {}

  RecorderOptions options;
  StationDescription description;
  StationSource source;
  pipeline::LocalModel local;
  std::shared_ptr<DiskCalls> disk;  // none: the system's

  // from the haptic loop and the camera thread
  Ring<std::byte> ring{kRingBytes};
  std::atomic<std::uint64_t> lost{0};
  std::mutex picture_mutex;
  std::vector<HeldPicture> offered;

  // from the operator's thread
  std::mutex mutex;
  std::condition_variable_any asked_for;  // the recorder's thread waits for a request
  std::condition_variable answered;       // the operator's for its answer
  std::optional<RecordingRequest> to_begin;
  std::shared_ptr<RecorderAnswer> begin_answer;
  std::shared_ptr<RecorderAnswer> end_answer;
  std::vector<Note> notes;
  RecorderStatus status;

  // the recorder's thread's own
  pipeline::Pipeline shadow;
  bool shadow_follows = true;
  bool seen_a_step = false;
  std::uint64_t last_step = 0;
  std::uint64_t steps_taken = 0;
  Instant newest{};  // step
  std::uint64_t differences = 0;
  StepHistory steps;
  PictureHistory pictures;
  StepRecord record;  // scratch
  std::vector<std::byte> packed = std::vector<std::byte>(kLargestPackedStep);
  std::unique_ptr<RecordingWriter> writer;
  RecorderStatus now_recording;
  RecordingHeader header;
  Instant written_until{};
  Instant newest_whole{};  // picture
  bool behind = false;     // more waits than one turn may write
  std::uint64_t lost_before = 0;
  std::uint64_t lost_told = 0;
  GrowthRate growth;
  std::vector<double> commits_ms;
  Instant next_second{};
  Instant worked_since{};
  double work_before_s = 0.0;  // of the processor's time

  std::jthread thread;

  void run(const std::stop_token& stop);
  [[nodiscard]] std::chrono::milliseconds turn() const;
  void takeSteps();
  void follow();
  void takePictures();
  void answerBegin(const RecordingRequest& request, const std::shared_ptr<RecorderAnswer>& answer);
  [[nodiscard]] Result<void> open(const RecordingRequest& request);
  /// Writes what waits: no more than a few steps and pictures at a time, so that a start takes nobody's processor.
  [[nodiscard]] Result<void> write(std::size_t most_steps, std::size_t most_pictures);
  [[nodiscard]] bool wholeIsDue(const HeldPicture& picture);
  [[nodiscard]] Result<void> writeNotes();
  [[nodiscard]] Result<void> everySecond(Instant now);
  [[nodiscard]] Result<void> close();
  void failed(const Message& problem);
  void publish();
};

}  // namespace fyd::session
