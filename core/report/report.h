// A report on a recording as one file: .html (self-contained, the figure as inline SVG) or .pdf (A4), drawn by the same
// code.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/recording/reader/recording.h"
#include "core/report/report_content.h"

namespace fyd::report {

/// @param path ends in .html or .pdf
/// @return an error when the recording cannot be read, the file not be written, or `progress` ended it; then there is
/// no file
[[nodiscard]] Result<void> writeReport(const recording::Recording& recording, const std::string& path, bool replace,
                                       const recording::Progress& progress = {});

/// The same for content that was gathered elsewhere.
[[nodiscard]] Result<void> writeReport(const ReportContent& content, const std::string& path, bool replace);

[[nodiscard]] Result<std::string> reportHtml(const ReportContent& content);
[[nodiscard]] Result<std::string> reportPdf(const ReportContent& content);

/// Whether a report can have this name. Looks at no file.
[[nodiscard]] Result<void> checkReportName(const std::string& path);
/// Whether `writeReport` can make the file, before anything is done that the report is to tell of. Leaves nothing there.
[[nodiscard]] Result<void> checkReportTarget(const std::string& path, bool replace);

inline constexpr double kReportWidth = 515.0;  ///< of an A4 page between its margins, points
/// Height of the figure with its legend; 0 when there is no strip.
[[nodiscard]] double figureHeight(const ReportContent& content);
/// The figure, its left upper corner at the origin.
void drawFigure(cairo_t* cairo, const ReportContent& content);

}  // namespace fyd::report
