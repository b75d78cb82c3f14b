// Lines of the readiness list about calibrations that are ageing or old. One that was never made is no line: a first
// session would begin with eight of them; the place "Calibrate" shows it.
#pragma once

#include <QDateTime>
#include <QElapsedTimer>
#include <vector>

#include "app/console/page.h"
#include "core/calibration/calibration_record.h"
#include "widgets/readiness_list.h"

namespace fyd::console {

/// Of the newest record of each part.
/// @param today "2026-11-21" or longer
[[nodiscard]] std::vector<widgets::ReadinessRow> ageingRows(const std::vector<calibration::CalibrationRecord>& records,
                                                            const station::Profile& profile, const std::string& today);

/// Looks at the record again when its file has changed, and once an hour for the date.
class CalibrationAges {
 public:
  explicit CalibrationAges(const PageContext& context) : context_(context) {}
  [[nodiscard]] const std::vector<widgets::ReadinessRow>& rows();

 private:
  PageContext context_;
  QElapsedTimer looked_;
  QDateTime changed_;
  std::vector<widgets::ReadinessRow> rows_;
};

}  // namespace fyd::console
