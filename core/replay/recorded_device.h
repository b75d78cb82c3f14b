// The device name "recording:FILE", and the start of playback, which touchpad and camera share.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/time.h"

namespace fyd::replay {

inline constexpr std::string_view kRecordingWord = "recording:";

/// FILE of "recording:FILE"; nothing for any other word.
[[nodiscard]] inline std::optional<std::string> recordingOf(std::string_view word) {
  if (!word.starts_with(kRecordingWord)) return std::nullopt;
  return std::string(word.substr(kRecordingWord.size()));
}

/// Time 0 of the recording on the station's clock: the time of the first call.
class PlaybackStart {
 public:
  [[nodiscard]] Instant at(Instant now) {
    const std::lock_guard lock(mutex_);
    if (!start_) start_ = now;
    return *start_;
  }

 private:
  std::mutex mutex_;
  std::optional<Instant> start_;
};

}  // namespace fyd::replay
