// The recorder as the other threads see it: the haptic loop's ring, the camera's queue, the operator's requests.
#include "core/session/recorder.h"

#include <array>

#include "core/session/recorder_impl.h"

namespace fyd::session {
namespace {

constexpr std::chrono::seconds kLongestWait{30};  // for a disk that does not answer
constexpr std::size_t kMostOffered = 64;          // pictures, two seconds of a usual camera's

}  // namespace

Recorder::Recorder(const RecorderOptions& options, const pipeline::Parameters& step, const pipeline::LocalModel& local,
                   StationDescription description, StationSource source)
    : impl_(std::make_unique<Impl>(options, step, local, std::move(description), std::move(source))) {}

Recorder::~Recorder() { shutDown(); }

void Recorder::writeThrough(std::shared_ptr<DiskCalls> disk) { impl_->disk = std::move(disk); }

void Recorder::start() {
  if (impl_->thread.joinable()) return;
  impl_->thread = std::jthread([impl = impl_.get()](const std::stop_token& stop) { impl->run(stop); });
}

void Recorder::shutDown() {
  if (!impl_->thread.joinable()) return;
  impl_->thread.request_stop();
  impl_->thread.join();
}

void Recorder::push(const StepView& step) noexcept {
  std::array<std::byte, kLargestPackedStep> packed;  // not initialised: only what is used is written
  const std::size_t bytes = packStep(step, packed);
  if (impl_->ring.write_available() < bytes) {
    impl_->lost.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  (void)impl_->ring.push(packed.data(), bytes);
}

void Recorder::offerPicture(const cv::Mat& picture, const cv::Rect& region, const sensing::FingerDetection& finger,
                            Instant taken, std::uint64_t number) {
  const std::lock_guard lock(impl_->picture_mutex);
  if (impl_->offered.size() >= kMostOffered) impl_->offered.erase(impl_->offered.begin());
  impl_->offered.push_back(
      {.picture = picture, .region_px = region, .finger = finger, .taken = taken, .number = number});
}

Result<void> Recorder::begin(const RecordingRequest& request) {
  if (request.path.empty()) return fail("recording: no file name");
  if (!impl_->thread.joinable()) return fail("{}: the recorder is not running", request.path);
  std::unique_lock lock(impl_->mutex);
  if (impl_->status.state == RecorderState::recording) {
    return fail("{}: {} is still being recorded; stop it first", request.path, impl_->status.path);
  }
  if (impl_->begin_answer) return fail("{}: another recording is being started", request.path);
  auto answer = std::make_shared<RecorderAnswer>();
  impl_->to_begin = request;
  impl_->begin_answer = answer;
  impl_->asked_for.notify_one();
  if (!impl_->answered.wait_for(lock, kLongestWait, [&] { return answer->done; })) {
    answer->abandoned = true;
    return fail("{}: the disk does not answer; nothing is recorded", request.path);
  }
  return answer->result;
}

Result<void> Recorder::end() {
  if (!impl_->thread.joinable()) return fail("the recorder is not running");
  std::unique_lock lock(impl_->mutex);
  if (impl_->status.state != RecorderState::recording) return fail("nothing is being recorded");
  auto answer = impl_->end_answer;
  if (!answer) answer = impl_->end_answer = std::make_shared<RecorderAnswer>();
  impl_->asked_for.notify_one();
  if (!impl_->answered.wait_for(lock, kLongestWait, [&] { return answer->done; })) {
    return fail("{}: the disk does not answer; the file is closed when it does", impl_->status.path);
  }
  return answer->result;
}

Result<void> Recorder::note(NoteKind kind, const std::string& text) {
  const std::lock_guard lock(impl_->mutex);
  if (impl_->status.state != RecorderState::recording) return fail("{}: not kept, nothing is being recorded", text);
  impl_->notes.push_back({.when = Clock::now(), .kind = kind, .text = text});
  return {};
}

RecorderStatus Recorder::status() const {
  const std::lock_guard lock(impl_->mutex);
  RecorderStatus out = impl_->status;
  return out;
}

}  // namespace fyd::session
