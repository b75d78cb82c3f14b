// A disk that fails in the midst of a recording.
#pragma once

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <limits>

#include "core/recording/file/recording_disk.h"

namespace fyd::recording {

/// Takes what is asked of it until something happens to it.
class TroubledDisk : public DiskCalls {
 public:
  int write(int file, std::span<const std::byte> bytes, std::uint64_t at) override {
    const int error = trouble;
    if (error == 0 && at + bytes.size() > full_at) return ENOSPC;
    return error != 0 ? error : DiskCalls::write(file, bytes, at);
  }
  int sync(int file) override { return trouble != 0 ? trouble.load() : DiskCalls::sync(file); }
  int resize(int file, std::uint64_t bytes) override {
    return trouble != 0 ? trouble.load() : DiskCalls::resize(file, bytes);
  }
  std::atomic<int> trouble{0};  // an errno
  std::atomic<std::uint64_t> full_at{std::numeric_limits<std::uint64_t>::max()};
};

}  // namespace fyd::recording
