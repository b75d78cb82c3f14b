#include "core/station/profile/calibrated_values.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/base/profile_text.h"
#include "core/base/whole_file.h"
#include "core/calibration/calibration_part.h"
#include "core/station/profile/calibration_records.h"
#include "core/station/profile/replace_file.h"
#include "core/station/profile/touchpad_name.h"

namespace fyd::station {
namespace {

constexpr std::string_view kOwner = "calibration.touchpad";

bool exists(const std::string& path) {
  std::error_code problem;
  return !path.empty() && (std::filesystem::exists(path, problem) || problem);
}

bool isCalibrated(const Parameter& parameter) { return !calibration::calibratedBy(parameter.id).empty(); }

/// The calibrated values and whose they are: what a file of values holds.
std::vector<Parameter> calibratedOnes(Profile& profile) {
  std::vector<Parameter> out = bindParameters(profile);
  std::erase_if(out, [](const Parameter& p) { return !isCalibrated(p) && p.id != kOwner; });
  return out;
}

void copyValue(const Parameter& from, const Parameter& to) {
  switch (to.kind) {
    case ParameterKind::list: to.list() = from.list(); break;
    case ParameterKind::text: to.text() = from.text(); break;
    default: to.set(from.value());
  }
}

/// Whether two profiles hold the same calibrated values, whose ever they are.
bool sameValues(Profile& a, Profile& b) {
  const auto mine = calibratedOnes(a), theirs = calibratedOnes(b);
  return std::ranges::equal(mine, theirs, [](const Parameter& x, const Parameter& y) {
    return x.id == kOwner || formatParameter(x) == formatParameter(y);
  });
}

/// The part that a value belongs to, in words; empty where other values of the same part tell which it is.
Message partOf(std::string_view id) {
  constexpr std::string_view kSensor = "sensing.ir";
  const std::string_view procedure = calibration::calibratedBy(id);
  if (procedure != "ir") return calibration::partName(procedure, 0);
  const char digit = id[kSensor.size()];
  return digit >= '1' && digit <= '8' ? calibration::partName(procedure, digit - '0') : Message{};
}

Message namesOf(const std::vector<std::string_view>& ids) {
  std::vector<Message> names;
  for (const std::string_view id : ids) {
    Message name = partOf(id);
    if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
  }
  return listed(std::move(names), "{}, {}");
}

/// @return ids of those that were something else
std::vector<std::string_view> setDefaults(Profile& profile) {
  Profile defaults;
  const auto usual = calibratedOnes(defaults), present = calibratedOnes(profile);
  std::vector<std::string_view> out;
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (present[i].id != kOwner && formatParameter(present[i]) != formatParameter(usual[i]))
      out.push_back(present[i].id);
    copyValue(usual[i], present[i]);
  }
  return out;
}

/// Sets back what simulated calibrations wrote into a profile that names no touchpad, each value by its newest record.
/// @return ids of the values
std::vector<std::string_view> dropSimulated(Profile& profile,
                                            const std::vector<calibration::CalibrationRecord>& records) {
  Profile defaults;
  const auto usual = calibratedOnes(defaults), present = calibratedOnes(profile);
  std::set<std::pair<std::string, int>> seen;
  std::vector<std::string_view> out;
  for (auto record = records.rbegin(); record != records.rend(); ++record) {
    for (const calibration::AppliedChange& change : record->changes) {
      const auto at = std::ranges::find(present, std::string_view(change.id), &Parameter::id);
      if (at == present.end() || change.before == change.after) continue;
      // Of a list that all distance sensors share, a sensor's record wrote its own entry.
      const int sensor = at->kind == ParameterKind::list && calibration::calibratedBy(change.id) == "ir" &&
                                 !change.id.starts_with(fmt::format("sensing.ir{}_", record->sensor))
                             ? record->sensor
                             : 0;
      if (!seen.emplace(change.id, sensor).second || !record->simulated) continue;
      if (!calibration::sameValue(formatParameter(*at), change.after, sensor)) continue;
      const Parameter& standard = usual[static_cast<std::size_t>(at - present.begin())];
      const auto entry = static_cast<std::size_t>(sensor - 1);
      if (sensor == 0) {
        copyValue(standard, *at);
      } else if (entry < at->list().size() && entry < standard.list().size()) {
        at->list()[entry] = standard.list()[entry];
      }
      out.push_back(at->id);
    }
  }
  return out;
}

/// A profile that names no touchpad, opened with one. @param path of its file; nothing there: it is new
Result<TouchpadProfile> adopted(Profile profile, const std::string& path, const std::string& touchpad) {
  profile.calibrated_on = touchpad;
  if (isSimulated(touchpad) || !exists(path)) return TouchpadProfile{std::move(profile), {}};
  const auto records = loadCalibrationRecords(path);
  if (!records) return tl::unexpected(records.error());
  if (const auto dropped = dropSimulated(profile, *records); !dropped.empty()) {
    return TouchpadProfile{std::move(profile),
                           say("{}: calibrated on the simulated touchpad, which a real one does not use: the defaults "
                               "are used instead ({})",
                               path, namesOf(dropped)),
                           true};
  }
  const bool unnamed = std::ranges::any_of(*records, [](const auto& r) { return !r.simulated && r.touchpad.empty(); });
  if (!unnamed) return TouchpadProfile{std::move(profile), {}};
  return TouchpadProfile{std::move(profile),
                         say("{}: its calibrations do not tell on which touchpad they were made; they are used with {}",
                             path, describeTouchpad(touchpad))};
}

}  // namespace

std::string valuesFileOf(const std::string& profile_path, const std::string& touchpad) {
  std::string word;
  for (const char c : touchpad) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (byte >= '0' && byte <= '9') || (byte >= 'A' && byte <= 'Z') || (byte >= 'a' && byte <= 'z');
    word += plain || c == '-' || c == '_' ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return fmt::format("{}.{}.toml", stemOf(profile_path), word);
}

void copyCalibratedValues(const Profile& from, Profile& to) {
  Profile source = from;  // binding wants a mutable instance
  const auto values = calibratedOnes(source), places = calibratedOnes(to);
  for (std::size_t i = 0; i < places.size(); ++i) copyValue(values[i], places[i]);
}

TouchpadProfile withDefaultsFor(Profile profile, const std::string& touchpad) {
  const std::string owner = profile.calibrated_on;
  if (owner == touchpad || (touchpad.empty() && !isSimulated(owner))) return {profile, {}};
  profile.calibrated_on = touchpad;
  if (owner.empty() || isPlayed(touchpad)) return {profile, {}};  // a recording moves no motor
  const auto changed = setDefaults(profile);
  profile.calibrated_on = touchpad;
  if (changed.empty()) return {profile, {}};
  return {profile,
          say("calibrated on {}, and this is {}: the defaults are used instead ({})", describeTouchpad(owner),
              describeTouchpad(touchpad), namesOf(changed)),
          true};
}

Result<TouchpadProfile> loadProfileFor(const std::string& path, const std::string& touchpad) {
  Profile profile;
  if (exists(path)) {
    auto loaded = loadProfile(path);
    if (!loaded) return tl::unexpected(loaded.error());
    profile = std::move(*loaded);
  }
  if (!touchpad.empty() && !isPlayed(touchpad) && profile.calibrated_on != touchpad) {
    if (const std::string file = valuesFileOf(path, touchpad); !path.empty() && exists(file)) {
      (void)setDefaults(profile);
      const auto text = readWholeFile(file, kLargestProfile_bytes);
      if (!text) return tl::unexpected(text.error());
      if (auto parsed = parseProfile(*text, file, calibratedOnes(profile)); !parsed) {
        return tl::unexpected(parsed.error());
      }
      profile.calibrated_on = touchpad;
      return TouchpadProfile{profile, {}};
    }
  }
  if (profile.calibrated_on.empty() && !isPlayed(touchpad)) return adopted(std::move(profile), path, touchpad);
  TouchpadProfile out = withDefaultsFor(std::move(profile), touchpad);
  if (!out.notice.empty()) out.notice = about(path, out.notice);
  return out;
}

Result<void> saveProfileFor(const Profile& profile, const std::string& path) {
  const std::string& touchpad = profile.calibrated_on;
  Profile present;
  if (exists(path)) {
    auto loaded = loadProfile(path);
    if (!loaded) return tl::unexpected(loaded.error());
    present = std::move(*loaded);
  }
  const bool own = touchpad.empty() ? present.calibrated_on.empty() : touchpad == present.calibrated_on;
  const bool first = present.calibrated_on.empty() && !isSimulated(touchpad) && !isPlayed(touchpad);
  if (own || first) return saveProfile(profile, path);

  Profile settings = profile;
  copyCalibratedValues(present, settings);
  if (isPlayed(touchpad) || touchpad.empty()) return saveProfile(settings, path);
  Profile values = profile;
  const std::string file = valuesFileOf(path, touchpad);
  if (!exists(file) && present.calibrated_on.empty() && sameValues(present, values)) return saveProfile(settings, path);
  // The settings first: a calibration leaves them as they are, so that its values are written last or not at all.
  if (auto saved = saveProfile(settings, path); !saved) return saved;
  return replaceFile(file, formatProfile(calibratedOnes(values)));
}

}  // namespace fyd::station
