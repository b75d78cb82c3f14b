// Pictures of the camera thread on their way to the recorder's thread, which keeps the last seconds of them.
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>

#include "core/recording/writer/picture_history.h"

namespace fyd::recording {

class PictureQueue {
 public:
  /// From the camera thread. A full queue, of as many bytes as the history, drops its oldest picture and counts it there.
  void offer(HeldPicture picture);
  /// From the recorder's thread: takes what was offered, and drops what was taken before `oldest` and is not to be read.
  void take(Instant oldest);
  [[nodiscard]] PictureHistory& history() { return pictures_; }

 private:
  std::mutex mutex_;
  std::deque<HeldPicture> offered_;
  std::size_t offered_bytes_ = 0;
  std::uint64_t dropped_ = 0;  // since `take`
  PictureHistory pictures_;    // the recorder's thread's
};

}  // namespace fyd::recording
