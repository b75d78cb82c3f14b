// The recorder's thread: keeps the last seconds at hand always, and writes them and what follows once asked.
//
//   haptic loop ─▶ ring of StepRecord ─▶ ┐                       ┌ pre-trigger (memory, 10 s)
//   camera thread ─▶ queue of pictures ─▶├─ recorder's thread ─▶ ┤
//   operator ─▶ notes ────────────────▶  ┘                       └ RecordingWriter (disk)
//
// A second Pipeline follows the recorded inputs on this thread; its state at the pre-trigger's first row goes into the
// file, so that a replay can start in the middle of a session, and the haptic loop never pays for a snapshot.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/pipeline/parameters.h"
#include "core/session/recording_types.h"
#include "core/session/step_record.h"
#include "core/texture/virtual_texture.h"

namespace fyd::session {

struct RecorderOptions {
  double pre_trigger_s = 10.0;
  double smallest_free_MB = 200.0;  ///< recording stops, closed and whole, before the disk has less
};

/// What the operator says of a recording when it starts.
struct RecordingRequest {
  std::string path;  ///< "….h5"
  std::string operator_name;
  std::string subject;
  std::string notes;
  std::vector<std::string> tags;
};

enum class RecorderState : std::uint8_t { idle, recording, failed };

struct RecorderStatus {
  RecorderState state = RecorderState::idle;
  std::string path;
  std::string problem;  ///< state failed: what happened, what is safe, what to do
  double seconds = 0.0;
  std::uint64_t bytes = 0;
  double bytes_per_s = 0.0;
  double minutes_left = pipeline::kNone;  ///< until the disk is full at this rate
  std::uint64_t lost = 0;                 ///< steps the ring could not take: an error, shown as such
  double commit_p99_ms = pipeline::kNone;
};

/// Words and texts of the station a recording needs; asked once when it starts.
struct StationDescription {
  std::string touchpad, camera, robot;
  std::string surface;  ///< TOML
};

class Recorder {
 public:
  /// @param profile the whole profile as TOML, asked from the recorder's thread when a recording starts
  Recorder(const RecorderOptions& options, const pipeline::Parameters& step,
           const std::optional<texture::SurfaceModel>& surface, StationDescription description,
           std::function<std::string()> profile);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  ~Recorder();  ///< closes the recording

  void start();     ///< the thread; before the haptic loop
  void shutDown();  ///< after the haptic loop: closes the recording, joins

  /// From the haptic loop only: never waits nor allocates; a full ring is counted.
  void push(const StepRecord& record) noexcept;
  /// From the camera thread.
  void offerPicture(const cv::Mat& picture, const cv::Rect& region, const sensing::FingerDetection& finger,
                    Instant taken, std::uint64_t number);

  // From the operator's thread:
  /// @return an error at once when the file cannot be made; then nothing is recorded
  [[nodiscard]] Result<void> begin(const RecordingRequest& request);
  /// Closes the file. @return its error, if any
  [[nodiscard]] Result<void> end();
  void note(NoteKind kind, const std::string& text);
  void link(const LinkRow& row);
  [[nodiscard]] RecorderStatus status() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fyd::session
