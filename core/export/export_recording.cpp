// Chooses the export by the file's extension.
#include "core/export/export_recording.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace fyd::exports {

Result<ExportResult> exportRecording(const recording::Recording& recording, const std::string& path,
                                     const ExportOptions& options) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  if (extension == ".csv") return exportCsv(recording, path, options);
  if (extension == ".mat") return exportMat(recording, path, options);
  if (extension == ".mkv" || extension == ".avi") return exportVideo(recording, path, options);
  if (extension == ".mcap") return exportMcap(recording, path, options);
  return fail("{}: an export ends in .csv, .mat, .mkv, .avi or .mcap", path);
}

}  // namespace fyd::exports
