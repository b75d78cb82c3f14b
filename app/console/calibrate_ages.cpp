#include "app/console/calibrate_ages.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>

#include "app/console/calibrate_records.h"
#include "app/console/calibrate_step.h"
#include "core/station/calibration_file.h"

namespace fyd::console {

std::vector<widgets::ReadinessRow> ageingRows(const std::vector<calibration::CalibrationRecord>& records,
                                              const station::Profile& profile, const std::string& today) {
  std::vector<widgets::ReadinessRow> out;
  if (records.empty()) return out;
  for (const auto& step : makeCalibrationSteps(profile)) {
    const PartState state = partStateOf(records, step->procedure(), step->sensor(), profile, today);
    if (!isDoubtful(state.kind)) continue;
    widgets::ReadinessRow row;
    row.what = QCoreApplication::translate("CalibrationAges", "%1: %2").arg(step->name(), state.words);
    row.ok = state.kind == PartState::Kind::ageing;
    row.remedy = step->tareTakesIt() && state.kind == PartState::Kind::outdated
                     ? QCoreApplication::translate("CalibrationAges",
                                                   "Take the tare, or calibrate it again under Calibrate. It does not "
                                                   "keep you from arming.")
                     : QCoreApplication::translate("CalibrationAges",
                                                   "Calibrate it again under Calibrate. It does not keep "
                                                   "you from arming.");
    out.push_back(row);
  }
  return out;
}

std::vector<widgets::ReadinessRow> CalibrationAges::rows() {
  const std::string profile = context_.tuning.profilePath().toStdString();
  const QDateTime changed = QFileInfo(QString::fromStdString(station::calibrationFileOf(profile))).lastModified();
  if (changed != changed_) {
    changed_ = changed;
    records_ = station::loadCalibrationRecords(profile).value_or(std::vector<calibration::CalibrationRecord>{});
  }
  return ageingRows(records_, context_.session.currentProfile(), nowUtc());
}

}  // namespace fyd::console
