#include "core/station/profile/calibration_file.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "core/base/system_reason.h"
#include "core/base/whole_file.h"
#include "core/base/write_target.h"
#include "core/calibration/calibration_dependence.h"
#include "core/control/control_parameters.h"
#include "core/station/profile/replace_file.h"

namespace fyd::station {
namespace {

constexpr std::uintmax_t kLargestRecord_bytes = 64 << 20;

/// @return the text, or nothing where there is no such file
Result<std::optional<std::string>> readRecordFile(const std::string& path) {
  std::error_code problem;
  if (!std::filesystem::exists(path, problem) && !problem) return std::nullopt;
  auto text = readWholeFile(path, kLargestRecord_bytes);
  if (!text) return tl::unexpected(text.error());
  return std::move(*text);
}

}  // namespace

std::string calibrationFileOf(const std::string& profile_path) {
  std::filesystem::path path(profile_path);
  const std::string stem = path.extension() == ".toml" ? path.stem().string() : path.filename().string();
  return (path.parent_path() / (stem + ".calibration.toml")).string();
}

Result<std::vector<calibration::CalibrationRecord>> loadCalibrationRecords(const std::string& profile_path) {
  const std::string path = calibrationFileOf(profile_path);
  const auto text = readRecordFile(path);
  if (!text) return tl::unexpected(text.error());
  if (!*text) return std::vector<calibration::CalibrationRecord>{};
  return calibration::parseRecords(**text, path);
}

Result<std::vector<OutdatedPart>> outdatedParts(const std::string& profile_path, Profile profile) {
  const auto records = loadCalibrationRecords(profile_path);
  if (!records) return tl::unexpected(records.error());
  std::vector<OutdatedPart> out;
  for (const std::string_view part : calibration::dependentParts()) {
    const auto bases = calibration::newerBases(*records, part, bindParameters(profile));
    if (!bases.empty()) out.push_back({std::string(part), calibration::describeBases(part, bases)});
  }
  return out;
}

Result<calibration::CalibrationRecord> saveCalibration(const calibration::CalibrationResult& result,
                                                       calibration::CalibrationRecord record, Profile& profile,
                                                       const std::string& profile_path) {
  if (!result.verdict.accepted)
    return fail("{}: refused, nothing is saved: {}", result.procedure, result.verdict.reason);
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
  record = calibration::makeRecord(result, std::move(*applied), record.sensor, std::move(record.who),
                                   std::move(record.when), std::move(record.conditions));
  records->push_back(record);

  // The record first: without one, a changed profile would have no date and no former values.
  const std::string path = calibrationFileOf(profile_path);
  const auto before = readRecordFile(path);
  if (!before) return tl::unexpected(before.error());
  const auto target = writeTargetOf(path);  // resolved before writing, so that a link stays a link
  if (!target) return tl::unexpected(target.error());
  if (auto written = replaceFile(path, calibration::formatRecords(*records)); !written) {
    return tl::unexpected(written.error());
  }
  if (auto saved = saveProfile(changed, profile_path); !saved) {
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
