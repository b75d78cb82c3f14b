// Free space on the disk that holds a recording, and the rate at which the recording grows.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "core/base/error.h"
#include "core/base/time.h"

namespace fyd::recording {

/// Bytes a user may still write to the file `path`, which has `written` already. A limit on the size of files (ulimit
/// -f) counts as a full disk.
[[nodiscard]] Result<std::uint64_t> freeBytes(const std::string& path, std::uint64_t written = 0);

/// Growth of a file over the last ten seconds.
class GrowthRate {
 public:
  void observe(Instant now, std::uint64_t bytes);
  [[nodiscard]] double bytes_per_s() const;  ///< 0 before there are two values

 private:
  struct Point {
    Instant when{};
    std::uint64_t bytes = 0;
  };
  std::deque<Point> points_;
};

}  // namespace fyd::recording
