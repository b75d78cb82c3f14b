// A disk that records all write, sync and resize calls, so that a test can simulate a power cut after any of them.
#pragma once

#include <cstring>
#include <random>
#include <vector>

#include "core/recording/file/recording_disk.h"

namespace fyd::recording::samples {

/// Records the calls in order.
class LoggingDisk final : public DiskCalls {
 public:
  struct Call {
    bool sync = false;
    std::uint64_t at = 0;
    std::vector<std::byte> bytes;  // empty: resize to `at`
  };
  int write(int file, std::span<const std::byte> bytes, std::uint64_t at) override {
    calls.push_back({false, at, {bytes.begin(), bytes.end()}});
    return DiskCalls::write(file, bytes, at);
  }
  int sync(int) override {
    calls.push_back({true, 0, {}});
    return 0;
  }
  int resize(int file, std::uint64_t bytes) override {
    calls.push_back({false, bytes, {}});
    return DiskCalls::resize(file, bytes);
  }
  std::vector<Call> calls;
};

/// The disk's content after a power cut at call `end`: what was synced, and a random mixture of unsynced sectors.
/// @param disk what it held before the first call
inline std::vector<std::byte> diskAfterCut(const std::vector<LoggingDisk::Call>& calls, std::size_t end,
                                           std::size_t sector_bytes, std::mt19937& random,
                                           std::vector<std::byte> disk = {}) {
  std::size_t synced = 0;
  for (std::size_t i = 0; i < end; ++i)
    if (calls[i].sync) synced = i;
  std::bernoulli_distribution keep(std::array{0.0, 0.1, 0.5, 0.9, 1.0}[random() % 5]);
  const bool whole_calls = random() % 2 == 0;  // else sector by sector
  for (std::size_t i = 0; i < end; ++i) {
    const auto& call = calls[i];
    if (call.sync) continue;
    if (whole_calls && i >= synced && random() % 2 == 0) continue;
    if (call.bytes.empty()) {
      if (i < synced || keep(random)) disk.resize(std::max<std::size_t>(disk.size(), call.at));
      continue;
    }
    for (std::size_t from = 0; from < call.bytes.size();) {
      const std::size_t length = std::min(call.bytes.size() - from, sector_bytes - (call.at + from) % sector_bytes);
      if (i < synced || whole_calls || keep(random)) {
        disk.resize(std::max(disk.size(), call.at + from + length));
        std::memcpy(disk.data() + call.at + from, call.bytes.data() + from, length);
      }
      from += length;
    }
  }
  return disk;
}

}  // namespace fyd::recording::samples
