// Inputs of a recorder besides steps and pictures, and its status.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/pipeline/parameters.h"
#include "core/recording/recording_types.h"

namespace fyd::recording {

/// A subject's code, such as S07: letters, digits, - and _, so that no whole name goes into a file. Empty: none.
inline constexpr std::size_t kLongestSubject = 32;
[[nodiscard]] bool isSubjectCode(std::string_view subject);
/// @return an error that says what was expected
[[nodiscard]] Result<void> checkSubject(const std::string& subject);

/// What the operator says of a recording when it starts.
struct RecordingRequest {
  std::string path;  ///< "….h5"
  std::string operator_name;
  std::string subject;  ///< isSubjectCode
  std::string notes;
  std::vector<std::string> tags;
};

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

struct StationDescription {
  std::string touchpad, camera, robot;  ///< as in the station's options (station_options.h)
  std::string lateness = {};            ///< as in RecordingHeader
};

/// What the recorder needs from the station.
struct StationSource {
  /// The whole profile as TOML, with these parameters of the step; asked on the recorder's thread while `begin`
  /// waits for it.
  std::function<std::string(const pipeline::Parameters&)> profile;
  /// Once a second while recording, on the recorder's thread; nothing: no link.
  std::function<std::optional<LinkRow>()> link;
};

}  // namespace fyd::recording
