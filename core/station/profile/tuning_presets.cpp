#include "core/station/profile/tuning_presets.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/base/profile_text.h"
#include "core/base/system_reason.h"
#include "core/base/whole_file.h"
#include "core/calibration/calibration_part.h"
#include "core/station/profile/replace_file.h"

namespace fyd::station {
namespace {

constexpr std::size_t kLongestName_characters = 40;
constexpr std::uintmax_t kLargestPreset_bytes = 1 << 20;
constexpr std::string_view kEnding = ".toml";

/// Presets of earlier versions hold these as well.
bool isTuned(const Parameter& parameter) { return parameter.info.live && parameter.isNumber(); }

std::filesystem::path fileOf(const std::string& folder, std::string_view name) {
  return std::filesystem::path(folder) / (std::string(name) + std::string(kEnding));
}

}  // namespace

Result<void> checkPresetName(std::string_view name) {
  // Bytes above 127 belong to letters of UTF-8; they count as characters by their first byte.
  const auto allowed = [](unsigned char c) {
    return c >= 0x80 || std::isalnum(c) != 0 || c == ' ' || c == '-' || c == '_';
  };
  const auto characters = std::count_if(name.begin(), name.end(), [](unsigned char c) { return (c & 0xC0U) != 0x80U; });
  const bool good = !name.empty() && static_cast<std::size_t>(characters) <= kLongestName_characters &&
                    name.front() != ' ' && name.back() != ' ' && std::all_of(name.begin(), name.end(), allowed);
  if (good) return {};
  return fail("preset '{}': expected a name of 1 to {} letters, digits, spaces, '-' or '_', with no space at its ends",
              name, kLongestName_characters);
}

std::string presetFolder(const std::string& profile_path) {
  return (std::filesystem::path(profile_path).parent_path() / "presets").string();
}

std::vector<std::string> presetNames(const std::string& folder) {
  std::vector<std::string> out;
  std::error_code problem;
  for (std::filesystem::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    std::error_code unknown;
    if (!entry->is_regular_file(unknown) || entry->path().extension() != kEnding) continue;
    std::string name = entry->path().stem().string();
    if (checkPresetName(name)) out.push_back(std::move(name));
  }
  std::sort(out.begin(), out.end());
  return out;
}

bool isInPreset(const Parameter& parameter) {
  return isTuned(parameter) && calibration::calibratedBy(parameter.id).empty();
}

std::string formatPreset(const Profile& profile) {
  Profile copy = profile;  // binding wants a mutable instance
  std::vector<Parameter> tuned = bindParameters(copy);
  std::erase_if(tuned, [](const Parameter& parameter) { return !isInPreset(parameter); });
  return formatProfile(tuned);
}

Result<Profile> parsePreset(std::string_view text, std::string_view source_name, const Profile& base) {
  Profile profile = base;
  Profile untouched = base;
  const std::vector<Parameter> bound = bindParameters(profile);
  const std::vector<Parameter> before = bindParameters(untouched);
  if (auto parsed = parseProfile(text, source_name, bound); !parsed) return tl::unexpected(parsed.error());
  for (std::size_t i = 0; i < bound.size(); ++i) {
    if (isTuned(bound[i]) && !isInPreset(bound[i])) bound[i].set(before[i].value());
    if (!isTuned(bound[i]) && formatParameter(bound[i]) != formatParameter(before[i])) {
      return fail("{}: {} cannot change while the station runs; a preset holds live parameters only", source_name,
                  bound[i].id);
    }
  }
  if (auto checked = control::checkControlParameters(profile.step.control); !checked) {
    return fail(about(source_name, checked.error().message));
  }
  return profile;
}

Result<std::string> readPreset(const std::string& folder, std::string_view name) {
  if (auto good = checkPresetName(name); !good) return tl::unexpected(good.error());
  return readWholeFile(fileOf(folder, name).string(), kLargestPreset_bytes);
}

Result<void> writePreset(const std::string& folder, std::string_view name, std::string_view text) {
  if (auto good = checkPresetName(name); !good) return good;
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) return fail("{}: the folder cannot be made: {}", folder, systemReason(problem));
  return replaceFile(fileOf(folder, name).string(), text);
}

Result<void> removePreset(const std::string& folder, std::string_view name) {
  if (auto good = checkPresetName(name); !good) return good;
  const std::filesystem::path path = fileOf(folder, name);
  std::error_code problem;
  if (!std::filesystem::remove(path, problem)) {
    return fail("{}: cannot be deleted: {}", path.string(), problem ? systemReason(problem) : say("no such file"));
  }
  return {};
}

}  // namespace fyd::station
