// The recorder's thread: keeps the last seconds at hand always, and writes them and what follows once asked.
//
//   haptic loop ─▶ ring of packed steps ─▶ ┐                       ┌ pre-trigger (memory, 10 s)
//   camera thread ─▶ queue of pictures ──▶ ├─ recorder's thread ─▶ ┤
//   operator ─▶ notes ───────────────────▶ ┘                       └ RecordingWriter (disk)
//
// A second Pipeline follows the recorded inputs on this thread; its state at the pre-trigger's first row goes into the
// file, so that a replay can start in the middle of a session, and the haptic loop never pays for a snapshot. It also
// proves all the time that what is recorded gives what was felt: any difference is counted.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/pipeline/local_model.h"
#include "core/pipeline/parameters.h"
#include "core/session/packed_step.h"
#include "core/session/recorder_options.h"
#include "core/session/recording_types.h"
#include "core/texture/virtual_texture.h"

namespace fyd::session {

/// What the operator says of a recording when it starts.
struct RecordingRequest {
  std::string path;  ///< "….h5"
  std::string operator_name;
  std::string subject;
  std::string notes;
  std::vector<std::string> tags;
};

class DiskCalls;

enum class RecorderState : std::uint8_t { idle, recording, failed };

struct RecorderStatus {
  RecorderState state = RecorderState::idle;
  std::string path;
  Message problem;  ///< state failed: what happened, what is safe, what to do
  double seconds = 0.0;
  std::uint64_t bytes = 0;
  double bytes_per_s = 0.0;
  double minutes_left = pipeline::kNone;  ///< until the disk is full at this rate
  std::uint64_t samples = 0;              ///< steps written, with those from before the start
  std::uint64_t lost = 0;                 ///< steps the ring could not take: an error, shown as such
  std::uint64_t taken = 0;                ///< steps taken from the ring since the recorder runs, recorded or not
  std::uint64_t pictures = 0;
  std::uint64_t pictures_lost = 0;
  std::uint64_t differences = 0;  ///< steps that the second Pipeline gave otherwise; anything but 0 is a fault of
                                  ///< this program: the recording cannot be replayed
  double commit_p99_ms = pipeline::kNone;
  double processor_percent = 0.0;  ///< of one core, the recorder's thread, since the recording (or the thread) began
};

/// Words of the station's options.
struct StationDescription {
  std::string touchpad, camera, robot;
};

/// What the recorder asks of the station.
struct StationSource {
  /// The whole profile as TOML, with these parameters of the step; asked on the recorder's thread while `begin`
  /// waits for it.
  std::function<std::string(const pipeline::Parameters&)> profile;
  /// Once a second while recording, on the recorder's thread; nothing: no link.
  std::function<std::optional<LinkRow>()> link;
};

class Recorder {
 public:
  Recorder(const RecorderOptions& options, const pipeline::Parameters& step, const pipeline::LocalModel& local,
           StationDescription description, StationSource source);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  ~Recorder();  ///< closes the recording

  /// Tests put broken disks here; before `start`.
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

}  // namespace fyd::session
