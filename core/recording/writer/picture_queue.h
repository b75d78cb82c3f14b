// Pictures of the camera thread on their way to the recorder's thread, which keeps the last seconds of them.
#pragma once

#include <mutex>
#include <vector>

#include "core/recording/writer/picture_history.h"

namespace fyd::recording {

class PictureQueue {
 public:
  /// From the camera thread. A full queue drops its oldest picture.
  void offer(HeldPicture picture);
  /// From the recorder's thread: takes what was offered, and drops what was taken before `oldest` and is not to be read.
  void take(Instant oldest);
  [[nodiscard]] PictureHistory& history() { return pictures_; }

 private:
  static constexpr std::size_t kMostOffered = 64;  // two seconds of a usual camera's

  std::mutex mutex_;
  std::vector<HeldPicture> offered_;
  PictureHistory pictures_;  // the recorder's thread's
};

}  // namespace fyd::recording
