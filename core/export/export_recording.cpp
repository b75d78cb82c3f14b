// Chooses the export by the file's extension.
#include "core/export/export_recording.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>

namespace fyd::exports {
namespace {

enum class ExportKind : std::uint8_t { csv, mat, video, mcap };

std::optional<ExportKind> exportKindOf(const std::string& path) {
  const std::string extension = extensionOf(path);
  if (extension == ".csv") return ExportKind::csv;
  if (extension == ".mat") return ExportKind::mat;
  if (extension == ".mkv" || extension == ".avi") return ExportKind::video;
  if (extension == ".mcap") return ExportKind::mcap;
  return std::nullopt;
}

}  // namespace

std::string extensionOf(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension;
}

std::vector<std::string> exportFiles(const std::string& path) {
  const auto beside = [&path](const char* ending) {
    return std::vector{path, std::filesystem::path(path).replace_extension(ending).string()};
  };
  const auto kind = exportKindOf(path);
  if (kind == ExportKind::csv) return beside(".events.csv");
  if (kind == ExportKind::video) return beside(".times.csv");
  return {path};
}

Result<void> checkExport(const std::string& path, const ExportOptions& options) {
  const auto kind = exportKindOf(path);
  if (!kind) return fail("{}: an export ends in .csv, .mat, .mkv, .avi or .mcap", path);
  if (kind == ExportKind::video && !options.fields.empty()) return fail("{}: a video has no fields to choose", path);
  if ((kind == ExportKind::csv || kind == ExportKind::mat) && options.region) {
    return fail("{}: a table has no pictures of which to take the region", path);
  }
  return checkSelection(options);
}

Result<ExportResult> exportRecording(const recording::Recording& recording, const std::string& path,
                                     const ExportOptions& options) {
  if (auto good = checkExport(path, options); !good) return tl::unexpected(good.error());
  switch (*exportKindOf(path)) {
    case ExportKind::csv: return exportCsv(recording, path, options);
    case ExportKind::mat: return exportMat(recording, path, options);
    case ExportKind::video: return exportVideo(recording, path, options);
    case ExportKind::mcap: break;
  }
  return exportMcap(recording, path, options);
}

}  // namespace fyd::exports
