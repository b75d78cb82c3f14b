#include "core/station/replace_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace fyd::station {
namespace {

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

Result<void> replaceFile(const std::string& path, std::string_view text) {
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
