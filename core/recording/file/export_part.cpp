#include "core/recording/file/export_part.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include "core/base/system_reason.h"

namespace fyd::recording {
namespace {

constexpr std::string_view kMark = ".fyd-part-";
constexpr std::string_view kRandom = "XXXXXX";  // as mkostemps wants it

bool isLetterOrDigit(char c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

/// True also on a file system without locks: there nothing is removed.
bool lockOwn(int file) {
  if (::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
  struct stat now {};
  return ::fstat(file, &now) == 0 && now.st_nlink == 1;  // else removed as a leftover before it was locked
}

/// No process holds its lock, and the name still refers to the opened file.
bool isAbandoned(int file, const char* path) {
  struct stat opened {
  }, named{};
  if (::fstat(file, &opened) != 0 || !S_ISREG(opened.st_mode)) return false;
  if (opened.st_uid != ::geteuid() || opened.st_nlink != 1) return false;
  if (::flock(file, LOCK_EX | LOCK_NB) != 0) return false;
  return ::lstat(path, &named) == 0 && named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
}

/// Without changing it, as umask() does: exports of two threads would leave each other's.
mode_t umaskOfProcess() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("Umask:")) return static_cast<mode_t>(std::stoul(line.substr(6), nullptr, 8));
  }
  return 077;  // unknown without a free descriptor: nobody sees what its user may have kept to himself
}

}  // namespace

Result<ExportPart> makeExportPart(const std::filesystem::path& wanted) {
  const std::string extension = wanted.extension().string();
  const std::string pattern =
      (wanted.parent_path() / fmt::format(".{}{}{}{}", wanted.stem().string(), kMark, kRandom, extension)).string();
  constexpr int kTries = 100;
  for (int i = 0; i < kTries; ++i) {
    std::string name = pattern;
    const int file = ::mkostemps(name.data(), static_cast<int>(extension.size()), O_CLOEXEC);
    if (file < 0) return fail("{}: cannot be written: {}", wanted.string(), systemReason(errno));
    if (!lockOwn(file)) {
      ::close(file);
      continue;
    }
    // mkstemp gives 0600; what a user exports is readable as their other files are.
    ::fchmod(file, 0666 & ~umaskOfProcess());
    return ExportPart{std::move(name), file};
  }
  return fail("{}: cannot be written: another program takes its part files away", wanted.string());
}

bool isExportPart(std::string_view name) {
  const auto mark = name.rfind(kMark);
  if (mark == std::string_view::npos || mark < 2 || name.front() != '.') return false;
  const std::string_view rest = name.substr(mark + kMark.size());
  if (rest.size() < kRandom.size() || !std::ranges::all_of(rest.substr(0, kRandom.size()), isLetterOrDigit)) {
    return false;
  }
  const std::string_view extension = rest.substr(kRandom.size());
  return extension.empty() || (extension.front() == '.' && extension.rfind('.') == 0);
}

std::size_t removeExportLeftovers(const std::filesystem::path& folder) {
  std::size_t removed = 0;
  std::error_code problem;
  std::filesystem::directory_iterator each(folder.empty() ? "." : folder, problem);
  for (; !problem && each != std::filesystem::directory_iterator{}; each.increment(problem)) {
    if (!isExportPart(each->path().filename().string())) continue;
    const std::string path = each->path().string();
    // Never through a link, never waiting for the other end of a pipe.
    const int file = ::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) continue;
    if (isAbandoned(file, path.c_str()) && ::unlink(path.c_str()) == 0) ++removed;
    ::close(file);
  }
  return removed;
}

}  // namespace fyd::recording
