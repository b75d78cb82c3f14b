#include "core/station/profile/calibration_file.h"

#include <unistd.h>

#include <algorithm>

#include "core/base/write_target.h"
#include "core/calibration/calibration_dependence.h"
#include "core/control/control_parameters.h"
#include "core/station/profile/calibrated_values.h"
#include "core/station/profile/replace_file.h"
#include "core/station/profile/touchpad_name.h"

namespace fyd::station {

Result<std::vector<OutdatedPart>> outdatedParts(const std::string& profile_path, Profile profile) {
  const auto loaded = loadCalibrationRecords(profile_path);
  if (!loaded) return tl::unexpected(loaded.error());
  const auto records = recordsFor(*loaded, profile.calibrated_on);
  std::vector<OutdatedPart> out;
  for (const std::string_view part : calibration::dependentParts()) {
    const auto bases = calibration::newerBases(records, part, bindParameters(profile));
    if (!bases.empty()) out.push_back({std::string(part), calibration::describeBases(part, bases)});
  }
  return out;
}

Result<calibration::CalibrationRecord> saveCalibration(const calibration::CalibrationResult& result,
                                                       calibration::CalibrationRecord record, Profile& profile,
                                                       const std::string& profile_path) {
  if (!result.verdict.accepted)
    return fail("{}: refused, nothing is saved: {}", result.procedure, result.verdict.reason);
  if (isPlayed(profile.calibrated_on)) {
    return fail("{}: a recording is played, nothing is saved: a calibration is made on a touchpad", result.procedure);
  }
  if (record.simulated && !isSimulated(profile.calibrated_on)) {
    return fail("{}: simulated points, nothing is saved: these values would be used by {}", result.procedure,
                describeTouchpad(profile.calibrated_on));
  }
  for (const calibration::ParameterChange& change : result.changes) {
    if (calibration::calibratedBy(change.id).empty()) {
      return fail("{}: {} is no calibrated value, nothing is saved", result.procedure, change.id);
    }
  }
  auto records = loadCalibrationRecords(profile_path);
  if (!records) return tl::unexpected(records.error());
  Profile changed = profile;
  auto applied = calibration::applyChanges(bindParameters(changed), result.changes);
  if (!applied) return tl::unexpected(applied.error());
  if (auto checked = control::checkControlParameters(changed.step.control); !checked)
    return tl::unexpected(checked.error());
  for (calibration::AppliedChange& left : calibration::leftBehind(result.procedure, bindParameters(changed))) {
    if (std::ranges::find(*applied, left.id, &calibration::AppliedChange::id) == applied->end()) {
      applied->push_back(std::move(left));
    }
  }
  record.touchpad = profile.calibrated_on;
  record.simulated = isSimulated(record.touchpad);
  record = calibration::makeRecord(result, std::move(*applied), std::move(record));
  records->push_back(record);

  // The record first: without one, a changed profile would have no date and no former values.
  const std::string path = calibrationFileOf(profile_path);
  const auto before = readCalibrationFile(profile_path);
  if (!before) return tl::unexpected(before.error());
  const auto target = writeTargetOf(path);  // resolved before writing, so that a link stays a link
  if (!target) return tl::unexpected(target.error());
  if (auto written = replaceFile(path, calibration::formatRecords(*records)); !written) {
    return tl::unexpected(written.error());
  }
  if (auto saved = saveProfileFor(changed, profile_path); !saved) {
    if (*before) {
      (void)replaceFile(path, **before);
    } else {
      ::unlink(target->path.c_str());
    }
    return tl::unexpected(saved.error());
  }
  profile = changed;
  return record;
}

}  // namespace fyd::station
