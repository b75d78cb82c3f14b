#include "core/recording/writer/picture_queue.h"

namespace fyd::recording {

void PictureQueue::offer(HeldPicture picture) {
  const std::lock_guard lock(mutex_);
  if (offered_.size() >= kMostOffered) offered_.erase(offered_.begin());
  offered_.push_back(std::move(picture));
}

void PictureQueue::take(Instant oldest) {
  std::vector<HeldPicture> taken;
  {
    const std::lock_guard lock(mutex_);
    taken.swap(offered_);
  }
  for (HeldPicture& picture : taken) pictures_.add(std::move(picture));
  pictures_.trim(oldest);
}

}  // namespace fyd::recording
