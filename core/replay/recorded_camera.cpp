#include "core/replay/recorded_camera.h"

#include <thread>

namespace fyd::replay {
namespace {

constexpr Duration kLongestWait = std::chrono::seconds(1);  // a camera's `next` returns about once a second

}  // namespace

RecordedCamera::RecordedCamera(std::string path, std::unique_ptr<recording::Recording> recording,
                               std::shared_ptr<PlaybackStart> start)
    : path_(std::move(path)), recording_(std::move(recording)), start_(std::move(start)) {}

Result<std::unique_ptr<device::Camera>> RecordedCamera::open(const std::string& path,
                                                             std::shared_ptr<PlaybackStart> start) {
  auto recording = recording::Recording::open(path);
  if (!recording) return tl::unexpected(recording.error());
  if ((*recording)->info().frames == 0) return fail("{}: the recording holds no picture", path);
  return std::unique_ptr<device::Camera>(new RecordedCamera(path, std::move(*recording), std::move(start)));
}

Message RecordedCamera::description() const {
  return say("recording {}, {} pictures, played once", path_, recording_->info().frames);
}

Result<device::CameraFrame> RecordedCamera::next() {
  const Instant start = start_->at(Clock::now());
  if (next_ >= recording_->info().frames) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return fail("{}: the recording has ended", path_);
  }
  auto picture = recording_->picture(next_);
  if (!picture) {
    ++next_;
    return tl::unexpected(picture.error());
  }
  const Instant due = start + fromSeconds(picture->time_s);
  if (due - Clock::now() > kLongestWait) {
    std::this_thread::sleep_for(kLongestWait);
    return fail("{}: the recording shows no picture for another {:.1f} s", path_, toSeconds(due - Clock::now()));
  }
  std::this_thread::sleep_until(due);
  ++next_;
  if (picture->whole.empty()) return fail("{}: picture {} was not kept", path_, picture->number);
  return device::CameraFrame{.picture = picture->whole, .taken = due, .number = picture->number};
}

}  // namespace fyd::replay
