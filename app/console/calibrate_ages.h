// Lines of the readiness list about calibrations that are ageing, old or rest on an older one of another part. One that
// was never made is no line: a first session would begin with eight of them; the place "Calibrate" shows it.
#pragma once

#include <QDateTime>
#include <vector>

#include "app/console/page.h"
#include "core/calibration/calibration_record.h"
#include "widgets/readiness_list.h"

namespace fyd::console {

/// Of each part.
/// @param today "2026-11-21" or longer
[[nodiscard]] std::vector<widgets::ReadinessRow> ageingRows(const std::vector<calibration::CalibrationRecord>& records,
                                                            const station::Profile& profile, const std::string& today);

/// Reads the record again when its file has changed. What it says depends on the date and on the values in force, too.
class CalibrationAges {
 public:
  explicit CalibrationAges(const PageContext& context) : context_(context) {}
  [[nodiscard]] std::vector<widgets::ReadinessRow> rows();

 private:
  PageContext context_;
  QDateTime changed_;  ///< no date: there was no file
  std::vector<calibration::CalibrationRecord> records_;
};

}  // namespace fyd::console
