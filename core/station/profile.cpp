#include "core/station/profile.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/base/profile_text.h"
#include "core/base/system_reason.h"
#include "core/station/replace_file.h"

namespace fyd::station {
namespace {

constexpr std::uintmax_t kLargestProfile_bytes = 1 << 20;

}  // namespace

Result<Profile> loadProfile(const std::string& path) {
  std::error_code problem;
  const std::uintmax_t size = std::filesystem::file_size(path, problem);
  if (problem) return fail("{}: cannot be read: {}", path, systemReason(problem));
  if (size > kLargestProfile_bytes) {
    return fail("{}: {} bytes; a profile has at most {}", path, size, kLargestProfile_bytes);
  }
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) return fail("{}: cannot be read", path);
  Profile profile;
  if (auto parsed = parseProfile(text, path, bindParameters(profile)); !parsed) return tl::unexpected(parsed.error());
  return profile;
}

Result<void> saveProfile(const Profile& profile, const std::string& path) {
  Profile copy = profile;  // binding wants a mutable instance
  return replaceFile(path, formatProfile(bindParameters(copy)));
}

}  // namespace fyd::station
