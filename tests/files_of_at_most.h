// A limit on the size of files, which stands for a disk that is nearly full.
#pragma once

#include <sys/resource.h>

#include <cerrno>
#include <csignal>
#include <system_error>

namespace fyd {

/// While it exists, no file of this process grows beyond so many bytes.
class FilesOfAtMost {
 public:
  explicit FilesOfAtMost(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    if (::getrlimit(RLIMIT_FSIZE, &before_) != 0) throw std::system_error(errno, std::generic_category(), "getrlimit");
    const rlimit small{.rlim_cur = bytes, .rlim_max = before_.rlim_max};
    if (::setrlimit(RLIMIT_FSIZE, &small) != 0) throw std::system_error(errno, std::generic_category(), "setrlimit");
  }
  ~FilesOfAtMost() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FilesOfAtMost(const FilesOfAtMost&) = delete;
  FilesOfAtMost& operator=(const FilesOfAtMost&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

}  // namespace fyd
