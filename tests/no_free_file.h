// A process that may open no further file, as when the system's limit is reached.
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace fyd {

/// The undefined-behaviour sanitizer reads what it doubts through a pipe; without a free file it takes a sound exception
/// for a damaged object.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kSanitizerNeedsAFile = true;
#else
inline constexpr bool kSanitizerNeedsAFile = false;
#endif

/// While it exists no file and no socket can be opened; those that are open stay so.
class NoFreeFile {
 public:
  NoFreeFile() {
    EXPECT_EQ(::getrlimit(RLIMIT_NOFILE, &before_), 0);
    const int lowest_free = ::dup(STDERR_FILENO);
    EXPECT_GE(lowest_free, 0);
    ::close(lowest_free);
    rlimit none = before_;
    none.rlim_cur = static_cast<rlim_t>(lowest_free);
    EXPECT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
  }
  NoFreeFile(const NoFreeFile&) = delete;
  NoFreeFile& operator=(const NoFreeFile&) = delete;
  ~NoFreeFile() { ::setrlimit(RLIMIT_NOFILE, &before_); }

 private:
  rlimit before_{};
};

}  // namespace fyd
