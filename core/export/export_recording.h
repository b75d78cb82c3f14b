// Exports a recording to a file other programs read; the file's extension says which:
//   .csv          telemetry, with events and notes beside it          (export_csv.cpp)
//   .mat          MATLAB 5: structs telemetry, units, header, events  (export_mat.cpp)
//   .mkv  .avi    the camera's pictures                               (export_video.cpp)
//   .mcap         telemetry, pictures, events, link for robotics viewers (export_mcap.cpp)
// Rows are read in blocks: memory does not grow with the recording. Only committed rows are exported.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/recording/progress.h"
#include "core/recording/reader/recording.h"

namespace fyd::exports {

struct ExportOptions {
  double from_s = -std::numeric_limits<double>::infinity();  ///< seconds from the recording's start
  double to_s = std::numeric_limits<double>::infinity();     ///< included
  std::vector<std::string> fields;                           ///< names of telemetryFields(); empty: all
  bool region = false;                ///< pictures: the detector's region of interest, exactly; else the whole picture
  bool replace = false;               ///< existing files may be replaced
  recording::Progress progress = {};  ///< if it ends the export, no file is left
};

struct ExportResult {
  std::vector<std::string> files;
  std::uint64_t rows = 0;      ///< of telemetry
  std::uint64_t pictures = 0;  ///< in the file, each counted once
  std::uint64_t repeated = 0;  ///< video: frames that repeat a picture, to keep time
  std::uint64_t left_out = 0;  ///< video: pictures that came faster than the video's rate
  double rate_Hz = 0.0;        ///< video: frames a second
  std::uint64_t lines = 0;     ///< events and notes
  std::uint64_t messages = 0;  ///< MCAP
};

/// The files that an export to `path` makes: that one, and the one beside it.
[[nodiscard]] std::vector<std::string> exportFiles(const std::string& path);

/// Of a path, with its dot, in small letters: the kind of file, however it is written.
[[nodiscard]] std::string extensionOf(const std::string& path);

/// Whether an export can be what its words say, whichever the recording: kind of file, fields, order of the bounds.
[[nodiscard]] Result<void> checkExport(const std::string& path, const ExportOptions& options);
/// Of these, fields and bounds (export_selection.cpp).
[[nodiscard]] Result<void> checkSelection(const ExportOptions& options);

/// Every file is written under a temporary name in the same folder, synced, then renamed: there is never half a file.
/// @return an error for an unknown extension or field, an empty range, an existing file, a full disk, and when
/// `progress` ended it
[[nodiscard]] Result<ExportResult> exportRecording(const recording::Recording& recording, const std::string& path,
                                                   const ExportOptions& options);

[[nodiscard]] Result<ExportResult> exportCsv(const recording::Recording& recording, const std::string& path,
                                             const ExportOptions& options);
[[nodiscard]] Result<ExportResult> exportMat(const recording::Recording& recording, const std::string& path,
                                             const ExportOptions& options);
[[nodiscard]] Result<ExportResult> exportVideo(const recording::Recording& recording, const std::string& path,
                                               const ExportOptions& options);
[[nodiscard]] Result<ExportResult> exportMcap(const recording::Recording& recording, const std::string& path,
                                              const ExportOptions& options);

}  // namespace fyd::exports
