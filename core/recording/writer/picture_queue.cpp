#include "core/recording/writer/picture_queue.h"

#include <utility>

namespace fyd::recording {

void PictureQueue::offer(HeldPicture picture) {
  const std::lock_guard lock(mutex_);
  offered_bytes_ += bytesOf(picture);
  offered_.push_back(std::move(picture));
  for (; offered_.size() > 1 && offered_bytes_ > PictureHistory::kMost_bytes; ++dropped_) {
    offered_bytes_ -= bytesOf(offered_.front());
    offered_.pop_front();
  }
}

void PictureQueue::take(Instant oldest) {
  std::deque<HeldPicture> taken;
  {
    const std::lock_guard lock(mutex_);
    taken.swap(offered_);
    offered_bytes_ = 0;
    pictures_.countLost(std::exchange(dropped_, 0));
  }
  for (HeldPicture& picture : taken) pictures_.add(std::move(picture));
  pictures_.trim(oldest);
}

}  // namespace fyd::recording
