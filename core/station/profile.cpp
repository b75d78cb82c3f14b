#include "core/station/profile.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/base/profile_text.h"

namespace fyd::station {
namespace {

constexpr std::uintmax_t kLargestProfile_bytes = 1 << 20;

Result<void> writeAndSync(const std::string& path, std::string_view text) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) return fail("{}: cannot be written: {}", path, std::strerror(errno));
  bool good = true;
  while (good && !text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    good = written > 0;
    if (good) text.remove_prefix(static_cast<std::size_t>(written));
  }
  good = good && ::fsync(file) == 0;
  const int problem = errno;
  ::close(file);
  if (!good) return fail("{}: writing failed: {}", path, std::strerror(problem));
  return {};
}

}  // namespace

Result<Profile> loadProfile(const std::string& path) {
  std::error_code problem;
  const std::uintmax_t size = std::filesystem::file_size(path, problem);
  if (problem) return fail("{}: cannot be read: {}", path, problem.message());
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
  const std::string text = formatProfile(bindParameters(copy));
  const std::string beside = path + ".new";
  if (auto written = writeAndSync(beside, text); !written) {
    ::unlink(beside.c_str());
    return written;
  }
  if (::rename(beside.c_str(), path.c_str()) != 0) {
    const int problem = errno;
    ::unlink(beside.c_str());
    return fail("{}: cannot be replaced: {}", path, std::strerror(problem));
  }
  return {};
}

}  // namespace fyd::station
