#include "core/report/report.h"

#include <cairo.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/recording/file/export_file.h"

namespace fyd::report {
namespace {

constexpr double kStripHeight = 96.0;
constexpr double kLabels = 12.0;  ///< room above the first strip for the marks' numbers
constexpr double kBelow = 6.0;

}  // namespace

double figureHeight(const ReportContent& content) {
  if (content.strips.empty()) return 0.0;
  return kLabels + kStripHeight * static_cast<double>(content.strips.size()) + kChartAxis + kBelow;
}

void drawFigure(cairo_t* cairo, const ReportContent& content) {
  ChartBox box{0.0, kLabels, kReportWidth, kStripHeight};
  drawMarkLabels(cairo, content.time, box, kLabels - 3.0);
  for (const ChartStrip& strip : content.strips) {
    drawStrip(cairo, strip, content.time, box);
    box.y += kStripHeight;
  }
  box.y -= kStripHeight;
  if (!content.strips.empty()) drawTimeAxis(cairo, content.time, box);
}

namespace {

/// In small letters.
std::string extensionOf(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension;
}

struct ReportTarget {
  bool pdf = false;  ///< else HTML
  recording::ExportFile file;
};

Result<ReportTarget> openTarget(const std::string& path, bool replace) {
  if (auto named = checkReportName(path); !named) return tl::unexpected(named.error());
  auto file = recording::ExportFile::create(path, replace);
  if (!file) return tl::unexpected(file.error());
  return ReportTarget{extensionOf(path) == ".pdf", std::move(*file)};
}

/// @param gather gives the content, once the file is known to be writable
template <class Gather>
Result<void> writeGathered(Gather&& gather, const std::string& path, bool replace,
                           const recording::Progress& progress) {
  auto target = openTarget(path, replace);
  if (!target) return tl::unexpected(target.error());
  const Result<ReportContent> content = gather();
  if (!content) return tl::unexpected(content.error());
  if (auto told = recording::tellProgress(progress, 1.0); !told) return told;
  const auto text = target->pdf ? reportPdf(*content) : reportHtml(*content);
  if (!text) return tl::unexpected(text.error());
  if (auto written = target->file.write(*text); !written) return written;
  return target->file.commit();
}

}  // namespace

Result<void> writeReport(const recording::Recording& recording, const std::string& path, bool replace,
                         const recording::Progress& progress) {
  return writeGathered([&] { return gatherReport(recording, progress); }, path, replace, progress);
}

Result<void> checkReportName(const std::string& path) {
  const std::string extension = extensionOf(path);
  if (extension == ".html" || extension == ".pdf") return {};
  return fail("{}: a report ends in .html or .pdf", path);
}

Result<void> checkReportTarget(const std::string& path, bool replace) {
  if (const auto target = openTarget(path, replace); !target) return tl::unexpected(target.error());
  return {};
}

Result<void> writeReport(const ReportContent& content, const std::string& path, bool replace) {
  return writeGathered([&]() -> Result<ReportContent> { return content; }, path, replace, {});
}

}  // namespace fyd::report
