// The printed report of a calibration: who, when, conditions, fit quality, every value before and after, the residuals
// of this calibration and of the one before it.
#pragma once

#include <string>
#include <vector>

#include "core/calibration/calibration_record.h"
#include "core/report/report_content.h"

namespace fyd::station {

struct CalibrationReport {
  calibration::CalibrationRecord record;
  bool accepted = true;               ///< false: a refused fit, whose values were not saved
  std::vector<std::size_t> outliers;  ///< indices of outlier points, where still known; from 0
};

/// The newest record of this part and the one before it.
struct RecordPair {
  const calibration::CalibrationRecord* newest = nullptr;
  const calibration::CalibrationRecord* former = nullptr;
};
[[nodiscard]] RecordPair newestOf(const std::vector<calibration::CalibrationRecord>& records,
                                  const std::string& procedure, int sensor);

/// @param former of the same part; nullptr: this is its first calibration
/// @param profile the file the values stand in; empty: none was written
[[nodiscard]] report::ReportContent gatherCalibrationReport(const CalibrationReport& report,
                                                            const calibration::CalibrationRecord* former,
                                                            const std::string& profile);

/// As .pdf or .html. @return an error when the file cannot be written; then there is none
[[nodiscard]] Result<void> writeCalibrationReport(const CalibrationReport& report,
                                                  const calibration::CalibrationRecord* former,
                                                  const std::string& profile, const std::string& path, bool replace);

}  // namespace fyd::station
