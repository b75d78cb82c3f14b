#include "app/console/shell/calibration_ages.h"

#include <QFileInfo>
#include <algorithm>
#include <set>

#include "core/calibration/calibration_dependence.h"
#include "core/calibration/calibration_part.h"
#include "core/station/profile/calibration_file.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/words.h"

namespace fyd::console {

namespace {

using widgets::tr;

/// The sensors of a part that have a record; the part itself where it has none or one only.
std::set<int> sensorsOf(const std::vector<calibration::CalibrationRecord>& records, std::string_view procedure) {
  std::set<int> sensors;
  for (const auto& record : records) {
    if (record.procedure == procedure) sensors.insert(record.sensor);
  }
  if (sensors.empty()) sensors.insert(0);
  return sensors;
}

}  // namespace

PartState partStateOf(const std::vector<calibration::CalibrationRecord>& records, const std::string& procedure,
                      int sensor, station::Profile profile, const std::string& today) {
  if (const auto bases = calibration::newerBases(records, procedure, bindParameters(profile)); !bases.empty()) {
    return {PartState::Kind::outdated, widgets::coreText(calibration::describeBases(procedure, bases))};
  }
  const auto newest = std::find_if(records.rbegin(), records.rend(), [&](const auto& record) {
    return record.procedure == procedure && record.sensor == sensor;
  });
  if (newest == records.rend()) return {PartState::Kind::never, tr("never calibrated")};
  const auto age = calibration::ageOf(*newest, today, profile.calibration);
  if (!age) return {PartState::Kind::old, widgets::coreText(age.error().message)};
  if (!calibration::inForce(*newest, bindParameters(profile))) {
    return {PartState::Kind::changed, age->days == 0 ? tr("changed since it was calibrated today")
                                      : age->days == 1
                                          ? tr("changed since it was calibrated yesterday")
                                          : tr("changed since it was calibrated %1 days ago").arg(age->days)};
  }
  switch (age->age) {
    case calibration::Age::ageing:
      return {PartState::Kind::ageing, tr("ageing: %1").arg(widgets::coreText(age->warning))};
    case calibration::Age::old: return {PartState::Kind::old, tr("old: %1").arg(widgets::coreText(age->warning))};
    case calibration::Age::fresh: break;
  }
  return {PartState::Kind::fine, age->days == 0   ? tr("fine: calibrated today")
                                 : age->days == 1 ? tr("fine: calibrated yesterday")
                                                  : tr("fine: calibrated %1 days ago").arg(age->days)};
}

std::string nowUtc() { return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString(); }

std::vector<widgets::ReadinessRow> ageingRows(const std::vector<calibration::CalibrationRecord>& records,
                                              const station::Profile& profile, const std::string& today) {
  std::vector<widgets::ReadinessRow> out;
  if (records.empty()) return out;
  for (const calibration::CalibrationPart& part : calibration::calibrationParts()) {
    const std::string procedure(part.procedure);
    for (const int sensor : sensorsOf(records, procedure)) {
      const PartState state = partStateOf(records, procedure, sensor, profile, today);
      if (!isDoubtful(state.kind)) continue;
      widgets::ReadinessRow row;
      row.what = tr("%1: %2").arg(widgets::coreText(calibration::partName(procedure, sensor)), state.words);
      row.ok = state.kind == PartState::Kind::ageing;
      row.remedy = part.tare_takes_it && state.kind == PartState::Kind::outdated
                       ? tr("Take the tare, or calibrate it again under Calibrate. It does not keep you from arming.")
                       : tr("Calibrate it again under Calibrate. It does not keep you from arming.");
      out.push_back(row);
    }
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
  const station::Profile in_force = context_.session.currentProfile();
  return ageingRows(station::recordsFor(records_, in_force.calibrated_on), in_force, nowUtc());
}

}  // namespace fyd::console
