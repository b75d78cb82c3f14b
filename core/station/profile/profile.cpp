#include "core/station/profile/profile.h"

#include <filesystem>

#include "core/base/profile_text.h"
#include "core/base/system_reason.h"
#include "core/base/whole_file.h"
#include "core/station/profile/replace_file.h"

template std::vector<fyd::Parameter> fyd::bindParameters(fyd::station::Profile& instance);

namespace fyd::station {

Result<Profile> loadProfile(const std::string& path) {
  const auto text = readWholeFile(path, kLargestProfile_bytes);
  if (!text) return tl::unexpected(text.error());
  Profile profile;
  if (auto parsed = parseProfile(*text, path, bindParameters(profile)); !parsed) return tl::unexpected(parsed.error());
  return profile;
}

Result<void> saveProfile(const Profile& profile, const std::string& path) {
  Profile copy = profile;  // binding wants a mutable instance
  return replaceFile(path, formatProfile(bindParameters(copy)));
}

}  // namespace fyd::station
