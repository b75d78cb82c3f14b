// The summary of a recording, and the values that are read from it.
//
// Times are seconds from the recording's start; rows are counted from 0.
// Stability: stable since 0.1
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/pipeline/telemetry.h"
#include "core/recording/recording_types.h"

namespace fyd::recording {

enum class Wholeness : std::uint8_t {
  whole,    ///< closed as it should be
  growing,  ///< another process is recording it
  crashed,  ///< its recorder ended without closing it; `recover` makes it whole
  damaged   ///< a commit or block fails its checksum, or no commit covers the last rows; see `recover`
};

struct RecordingInfo {
  std::string path;  ///< by which it was opened
  RecordingHeader header;
  Wholeness wholeness = Wholeness::whole;
  double duration_s = 0.0;              ///< from its start to its last row
  std::uint64_t samples = 0;            ///< rows present
  std::uint64_t committed_samples = 0;  ///< rows to trust
  std::uint64_t frames = 0;             ///< pictures
  std::uint64_t gaps = 0;               ///< samples lost, not missed cycles
  std::uint64_t events = 0;
  std::uint64_t bytes = 0;          ///< of the file
  Message damage;                   ///< when wholeness is damaged: what is damaged
  std::uint64_t unproven_rows = 0;  ///< of all tables, at their ends, which no sound commit proves: they are not read
  /// "/inputs/finger quality": what this program records and the file's did not, nor that of the recording it was copied
  /// from; read as the value of a new struct…
  std::vector<std::string> missing_columns;
  std::vector<std::string> unknown_columns;  ///< …and what only the file's program knows, which is not read
};

/// Smallest and largest of one telemetry field over a stretch of rows; NaN both when it holds no number.
struct MinMax {
  double low = pipeline::kNone;
  double high = pipeline::kNone;
};

struct Overview {
  std::vector<double> time_s;  ///< start of each bucket
  std::vector<MinMax> values;
};

struct RecordedPicture {
  double time_s = 0.0;
  std::uint64_t number = 0;
  cv::Mat whole;   ///< what lies around the region as compressed, perhaps of an earlier picture; the region exactly
  cv::Mat region;  ///< exactly as the detector saw it
  cv::Rect region_px;
  sensing::FingerDetection finger;
};

/// Nanoseconds: instants in a file are arbitrary, and their sums and differences must not overflow.
__extension__ using WideTime = __int128;

/// Seconds from the recording's start.
[[nodiscard]] inline double secondsInto(const RecordingInfo& info, Instant when) {
  return static_cast<double>(WideTime{when.time_since_epoch().count()} -
                             info.header.started.time_since_epoch().count()) /
         1e9;
}

}  // namespace fyd::recording
