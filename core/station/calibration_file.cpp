#include "core/station/calibration_file.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/base/system_reason.h"
#include "core/base/write_target.h"
#include "core/calibration/calibration_dependence.h"
#include "core/control/control_parameters.h"
#include "core/station/replace_file.h"

namespace fyd::station {
namespace {

constexpr std::uintmax_t kLargestRecord_bytes = 64 << 20;

struct RecordFile {
  bool exists = false;
  std::string text;
};

Result<RecordFile> readRecordFile(const std::string& path) {
  std::error_code problem;
  const std::uintmax_t size = std::filesystem::file_size(path, problem);
  if (problem == std::errc::no_such_file_or_directory) return RecordFile{};
  if (problem) return fail("{}: cannot be read: {}", path, systemReason(problem));
  if (size > kLargestRecord_bytes) {
    return fail("{}: {} bytes; at most {}: move it away, a new one will be begun", path, size, kLargestRecord_bytes);
  }
  std::ifstream file(path, std::ios::binary);
  RecordFile out{true, {std::istreambuf_iterator<char>(file), {}}};
  if (!file) return fail("{}: cannot be read", path);
  return out;
}

}  // namespace

std::string calibrationFileOf(const std::string& profile_path) {
  std::filesystem::path path(profile_path);
  const std::string stem = path.extension() == ".toml" ? path.stem().string() : path.filename().string();
  return (path.parent_path() / (stem + ".calibration.toml")).string();
}

Result<std::vector<calibration::CalibrationRecord>> loadCalibrationRecords(const std::string& profile_path) {
  const std::string path = calibrationFileOf(profile_path);
  const auto file = readRecordFile(path);
  if (!file) return tl::unexpected(file.error());
  if (!file->exists) return std::vector<calibration::CalibrationRecord>{};
  return calibration::parseRecords(file->text, path);
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

  // The record first: a profile that changed without a record would have no age and no way back.
  const std::string path = calibrationFileOf(profile_path);
  const auto before = readRecordFile(path);
  if (!before) return tl::unexpected(before.error());
  const auto target = writeTargetOf(path);  // before it is there: a link stays
  if (!target) return tl::unexpected(target.error());
  if (auto written = replaceFile(path, calibration::formatRecords(*records)); !written) {
    return tl::unexpected(written.error());
  }
  if (auto saved = saveProfile(changed, profile_path); !saved) {
    if (before->exists) {
      (void)replaceFile(path, before->text);
    } else {
      ::unlink(target->path.c_str());
    }
    return tl::unexpected(saved.error());
  }
  profile = changed;
  return record;
}

}  // namespace fyd::station
