// The content of a report, gathered from a recording or a calibration; the source of both HTML and PDF.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/export/export_words.h"
#include "core/export/touches.h"
#include "core/recording/progress.h"
#include "core/recording/reader/recording.h"
#include "core/report/chart.h"

namespace fyd::report {

/// Of each curve: about two for each point of the figure's width.
inline constexpr std::size_t kCurveBuckets = 900;

struct ReportColumn {
  std::string title;
  double share = 1.0;   ///< of the table's width
  bool number = false;  ///< right-aligned
};

struct ReportTable {
  std::string heading;
  std::string remark;  ///< below the heading: why the table is empty, or which rows are left out
  std::vector<ReportColumn> columns;
  std::vector<std::vector<std::string>> rows;
};

struct ReportContent {
  std::string title;
  std::string kind = "session report";                     ///< at the foot of each page
  std::vector<std::pair<std::string, std::string>> facts;  ///< name and text, which may have several lines
  std::vector<ChartStrip> strips;
  ChartTime time;
  std::string figure = "Force, indentation, stiffness and vibration over the session";  ///< text alternative
  std::string legend;                                                                   ///< of the figure
  std::vector<ReportTable> tables;  ///< touches, health, gains and calibration, log
};

/// All texts are valid UTF-8, nothing is escaped.
/// @return the reader's error, and one when `progress` ended it
[[nodiscard]] Result<ReportContent> gatherReport(const recording::Recording& recording,
                                                 const recording::Progress& progress = {});

/// The strips of the whole recording, and its time axis with touches; the caller adds marks and gaps.
[[nodiscard]] Result<void> gatherStrips(const recording::Recording& recording, ReportContent& content);

/// Gains and calibration in use: the most important ones, and every other that is not at its default.
[[nodiscard]] ReportTable profileTable(const std::string& profile_toml);

/// A number as printed, "–" for NaN.
[[nodiscard]] std::string reportNumber(double value, int decimals);

}  // namespace fyd::report
