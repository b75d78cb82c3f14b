#include "core/base/write_target.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>

#include "core/base/system_reason.h"

namespace fyd {
namespace {

constexpr int kMostLinks = 40;  // as the kernel
constexpr mode_t kModeBits = 07777;

/// Also for a link whose file does not exist yet. Nothing: a circle.
std::optional<std::string> followed(std::filesystem::path path) {
  for (int links = 0; links <= kMostLinks; ++links) {
    std::error_code none;
    const std::filesystem::path to = std::filesystem::read_symlink(path, none);
    if (none) return path.string();
    path = path.parent_path() / to;  // an absolute one replaces what stands before it
  }
  return std::nullopt;
}

}  // namespace

Result<WriteTarget> writeTargetOf(const std::string& path) {
  const auto end = followed(path);
  if (!end) return fail("{}: its links run in a circle", path);
  WriteTarget target{.path = *end};
  struct stat status {};
  if (::lstat(end->c_str(), &status) != 0) {
    if (errno == ENOENT) return target;
    return fail("{}: cannot be written: {}", path, systemReason(errno));
  }
  switch (status.st_mode & S_IFMT) {
    case S_IFREG: break;
    case S_IFDIR: return fail("{}: is a folder, not a file", path);
    case S_IFIFO: return fail("{}: is a pipe, not a file", path);
    case S_IFSOCK: return fail("{}: is a socket, not a file", path);
    default: return fail("{}: is a device, not a file", path);
  }
  if (::faccessat(AT_FDCWD, end->c_str(), W_OK, AT_EACCESS) != 0)
    return fail("{}: cannot be written: {}", path, systemReason(errno));
  target.exists = true;
  target.mode = status.st_mode & kModeBits;
  target.owner = status.st_uid;
  target.group = status.st_gid;
  return target;
}

Result<void> takeOver(const WriteTarget& replaced, int descriptor) {
  if (!replaced.exists) return {};
  struct stat own {};
  if (::fstat(descriptor, &own) != 0) return fail("{}: cannot be written: {}", replaced.path, systemReason(errno));
  const bool another = own.st_uid != replaced.owner || own.st_gid != replaced.group;
  if (another && ::fchown(descriptor, replaced.owner, replaced.group) != 0)
    return fail("{}: belongs to another user (uid {}, gid {}), who would lose it; choose another name", replaced.path,
                replaced.owner, replaced.group);
  if (::fchmod(descriptor, replaced.mode) != 0)  // after the owner, whose change takes bits away
    return fail("{}: cannot be written: {}", replaced.path, systemReason(errno));
  return {};
}

bool isOwnDescriptor(const std::string& path) {
  constexpr std::array kNames{std::string_view("/dev/stdout"), std::string_view("/dev/stderr")};
  constexpr std::array kFolders{std::string_view("/dev/fd/"), std::string_view("/proc/self/fd/")};
  return std::ranges::find(kNames, path) != kNames.end() ||
         std::ranges::any_of(kFolders, [&](std::string_view folder) { return path.starts_with(folder); });
}

}  // namespace fyd
