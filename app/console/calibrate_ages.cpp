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
    if (state.kind != PartState::Kind::ageing && state.kind != PartState::Kind::old) continue;
    widgets::ReadinessRow row;
    row.what = QCoreApplication::translate("CalibrationAges", "%1: %2").arg(step->name(), state.words);
    row.ok = state.kind == PartState::Kind::ageing;
    row.remedy = QCoreApplication::translate("CalibrationAges",
                                             "Calibrate it again under Calibrate. It does not keep "
                                             "you from arming.");
    out.push_back(row);
  }
  return out;
}

const std::vector<widgets::ReadinessRow>& CalibrationAges::rows() {
  constexpr qint64 kHour_ms = 3'600'000;
  const std::string profile = context_.tuning.profilePath().toStdString();
  const QDateTime changed = QFileInfo(QString::fromStdString(station::calibrationFileOf(profile))).lastModified();
  if (looked_.isValid() && looked_.elapsed() < kHour_ms && changed == changed_) return rows_;
  looked_.start();
  changed_ = changed;
  const auto records = station::loadCalibrationRecords(profile);
  rows_ = records ? ageingRows(*records, context_.session.currentProfile(), nowUtc())
                  : std::vector<widgets::ReadinessRow>{};
  return rows_;
}

}  // namespace fyd::console
