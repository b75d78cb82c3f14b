#include "core/recording/writer/disk_space.h"

#include <sys/resource.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/base/system_reason.h"

namespace fyd::recording {

Result<std::uint64_t> freeBytes(const std::string& path, std::uint64_t written) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const std::string name = folder.empty() ? "." : folder.string();
  struct statvfs disk {};
  if (::statvfs(name.c_str(), &disk) != 0) return fail(about(name, systemReason(errno)));
  const auto free = static_cast<std::uint64_t>(disk.f_bavail) * static_cast<std::uint64_t>(disk.f_frsize);
  rlimit limit{};
  if (::getrlimit(RLIMIT_FSIZE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return free;
  return std::min<std::uint64_t>(free, limit.rlim_cur > written ? limit.rlim_cur - written : 0);
}

void GrowthRate::observe(Instant now, std::uint64_t bytes) {
  points_.push_back({.when = now, .bytes = bytes});
  while (points_.size() > 2 && now - points_.front().when > std::chrono::seconds(10)) points_.pop_front();
}

double GrowthRate::bytes_per_s() const {
  if (points_.size() < 2 || points_.back().bytes < points_.front().bytes) return 0.0;
  const double elapsed_s = toSeconds(points_.back().when - points_.front().when);
  return elapsed_s > 0.0 ? static_cast<double>(points_.back().bytes - points_.front().bytes) / elapsed_s : 0.0;
}

}  // namespace fyd::recording
