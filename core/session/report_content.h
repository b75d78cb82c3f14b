// What a report says, gathered from a recording or a calibration; HTML and PDF both print this.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/session/chart.h"
#include "core/session/export_words.h"
#include "core/session/progress.h"
#include "core/session/recording.h"
#include "core/session/touches.h"

namespace fyd::session {

struct ReportColumn {
  std::string title;
  double share = 1.0;   ///< of the table's width
  bool number = false;  ///< to the right
};

struct ReportTable {
  std::string heading;
  std::string remark;  ///< below the heading; why the table is empty, or what it leaves out
  std::vector<ReportColumn> columns;
  std::vector<std::vector<std::string>> rows;
};

struct ReportContent {
  std::string title;
  std::string kind = "session report";                     ///< at the foot of each page
  std::vector<std::pair<std::string, std::string>> facts;  ///< what, and its text; may have several lines
  std::vector<ChartStrip> strips;
  ChartTime time;
  std::string figure = "Force, indentation, stiffness and vibration over the session";  ///< for who cannot see it
  std::string legend;                                                                   ///< of the figure
  std::vector<ReportTable> tables;  ///< touches, health, gains and calibration, log
};

/// All texts are valid UTF-8, nothing is escaped.
/// @return the reader's error, and one when `progress` ended it
[[nodiscard]] Result<ReportContent> gatherReport(const Recording& recording, const Progress& progress = {});

/// The strips of the whole session, and its time axis with touches; marks and gaps are left to the caller.
[[nodiscard]] Result<void> gatherStrips(const Recording& recording, ReportContent& content);

/// Gains and calibration in use: those that matter most, and every other that is not at its default.
[[nodiscard]] ReportTable profileTable(const std::string& profile_toml);

/// A number for reading, "–" where there is none.
[[nodiscard]] std::string reportNumber(double value, int decimals);

}  // namespace fyd::session
