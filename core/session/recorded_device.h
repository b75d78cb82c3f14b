// The word "recording:FILE" for a device, and the moment at which playing began: touchpad and camera share it.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/time.h"

namespace fyd::session {

inline constexpr std::string_view kRecordingWord = "recording:";

/// FILE of "recording:FILE"; nothing when the word says something else.
[[nodiscard]] inline std::optional<std::string> recordingOf(std::string_view word) {
  if (!word.starts_with(kRecordingWord)) return std::nullopt;
  return std::string(word.substr(kRecordingWord.size()));
}

/// Time 0 of the recording on the station's clock: the first that asks says when.
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

}  // namespace fyd::session
