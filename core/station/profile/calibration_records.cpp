#include "core/station/profile/calibration_records.h"

#include <filesystem>

#include "core/base/whole_file.h"
#include "core/station/profile/touchpad_name.h"

namespace fyd::station {
namespace {

constexpr std::uintmax_t kLargestRecord_bytes = 64 << 20;

}  // namespace

std::string stemOf(const std::string& profile_path) {
  const std::filesystem::path path(profile_path);
  const std::string stem = path.extension() == ".toml" ? path.stem().string() : path.filename().string();
  return (path.parent_path() / stem).string();
}

std::string calibrationFileOf(const std::string& profile_path) { return stemOf(profile_path) + ".calibration.toml"; }

Result<std::optional<std::string>> readCalibrationFile(const std::string& profile_path) {
  const std::string path = calibrationFileOf(profile_path);
  std::error_code problem;
  if (!std::filesystem::exists(path, problem) && !problem) return std::nullopt;
  auto text = readWholeFile(path, kLargestRecord_bytes);
  if (!text) return tl::unexpected(text.error());
  return std::move(*text);
}

Result<std::vector<calibration::CalibrationRecord>> loadCalibrationRecords(const std::string& profile_path) {
  const auto text = readCalibrationFile(profile_path);
  if (!text) return tl::unexpected(text.error());
  if (!*text) return std::vector<calibration::CalibrationRecord>{};
  return calibration::parseRecords(**text, calibrationFileOf(profile_path));
}

std::vector<calibration::CalibrationRecord> recordsFor(std::vector<calibration::CalibrationRecord> records,
                                                       std::string_view touchpad) {
  std::erase_if(records, [&](const calibration::CalibrationRecord& record) {
    if (isSimulated(touchpad) || record.simulated) return isSimulated(touchpad) != record.simulated;
    return !touchpad.empty() && !record.touchpad.empty() && record.touchpad != touchpad;
  });
  return records;
}

}  // namespace fyd::station
