// The recorder's own thread: follows the step, keeps the last seconds, writes.
#include <spdlog/spdlog.h>

#include <algorithm>

#include "core/session/recorder_impl.h"
#include "core/session/step_compare.h"

namespace fyd::session {
namespace {

// Two turns for each commit: a thread that wakes often finds its caches cold each time, and takes half as much again.
constexpr std::chrono::milliseconds kTurn{125};
constexpr std::chrono::milliseconds kShortestTurn{10};
// While it writes what was kept from before the start: in small portions, so that it takes nobody's processor.
constexpr std::chrono::milliseconds kTurnBehind{20};
constexpr std::size_t kMostSteps = 400;   // a turn
constexpr std::size_t kMostPictures = 8;  // a turn: twice what a usual camera gives

}  // namespace

// A turn ends when the next commit is due, so that nothing waits for it longer than its own 250 steps.
std::chrono::milliseconds Recorder::Impl::turn() const {
  if (!writer) return kTurn;
  if (behind) return kTurnBehind;
  const std::chrono::milliseconds until_commit(kBlockSteps - now_recording.samples % kBlockSteps + 1);
  return std::clamp(until_commit, kShortestTurn, kTurn);
}

void Recorder::Impl::run(const std::stop_token& stop) {
  worked_since = Clock::now();
  while (!stop.stop_requested()) {
    {
      std::unique_lock lock(mutex);
      asked_for.wait_for(lock, stop, turn(), [this] { return to_begin || end_answer; });
    }
    takeSteps();
    takePictures();
    std::optional<RecordingRequest> beginning;
    std::shared_ptr<RecorderAnswer> begins;
    std::shared_ptr<RecorderAnswer> ends;
    {
      const std::lock_guard lock(mutex);
      beginning = std::exchange(to_begin, std::nullopt);
      begins = begin_answer;
      ends = end_answer;
    }
    if (beginning) answerBegin(*beginning, begins);
    if (writer) {
      auto written = write(kMostSteps, kMostPictures);
      if (written) written = everySecond(Clock::now());
      if (!written && writer) failed(written.error().message);
    }
    if (ends) {
      const Result<void> closed = writer ? close() : fail(now_recording.problem);
      const std::lock_guard lock(mutex);
      ends->result = closed;
      ends->done = true;
      end_answer.reset();
      status = now_recording;
      answered.notify_all();
    }
    publish();
  }
  takeSteps();
  takePictures();
  if (!writer) return;
  if (const auto closed = close(); !closed) spdlog::error("Recording: {}", closed.error().text());
}

void Recorder::Impl::takeSteps() {
  while (ring.read_available() >= packedHeadSize()) {
    ring.pop(packed.data(), packedHeadSize());
    const std::size_t bytes = packedSize(packed);
    ring.pop(packed.data() + packedHeadSize(), bytes - packedHeadSize());  // one push gave both
    const std::span<const std::byte> step(packed.data(), bytes);
    unpackStep(step, record);
    follow();
    ++steps_taken;
    newest = record.inputs.now;
    steps.add(step, newest);
  }
  const Instant oldest = newest - fromSeconds(options.pre_trigger_s);
  steps.trim(oldest, 3 * static_cast<std::size_t>(options.pre_trigger_s) + 2);
  pictures.trim(oldest);
}

// The second pipeline takes the same step. What it was before a chunk's first row goes into the history.
void Recorder::Impl::follow() {
  if (seen_a_step && record.telemetry.step != last_step + 1) shadow_follows = false;  // a step was lost: see the manual
  seen_a_step = true;
  last_step = record.telemetry.step;
  if (steps.chunkIsDue()) {
    steps.beginChunk({.state = shadow_follows ? shadow.saveState() : std::string{}, .parameters = shadow.parameters()});
  }
  if (!shadow_follows) return;
  const pipeline::Outputs& outputs = shadow.step(record.inputs);
  if (sameStep(record.telemetry, record.motors, outputs.telemetry, outputs.motors)) return;
  if (differences++ == 0) {
    const auto difference = compareSteps(record.telemetry, record.motors, outputs.telemetry, outputs.motors);
    spdlog::error("Recording: step {} came out otherwise a second time ({} by {:g}); recordings cannot be replayed",
                  last_step, difference->field, difference->absolute);
  }
}

void Recorder::Impl::takePictures() {
  std::vector<HeldPicture> taken;
  {
    const std::lock_guard lock(picture_mutex);
    taken.swap(offered);
  }
  for (HeldPicture& picture : taken) pictures.add(std::move(picture));
}

void Recorder::Impl::answerBegin(const RecordingRequest& request, const std::shared_ptr<RecorderAnswer>& answer) {
  const Result<void> opened = open(request);
  const std::lock_guard lock(mutex);
  answer->result = opened;
  answer->done = true;
  begin_answer.reset();
  if (opened) {
    notes.clear();
    status = now_recording;
  }
  answered.notify_all();
  if (answer->abandoned && writer) end_answer = std::make_shared<RecorderAnswer>();
}

void Recorder::Impl::publish() {
  if (writer) {
    now_recording.bytes = writer->bytes();
    now_recording.seconds = toSeconds(written_until - header.started);
  }
  now_recording.lost = lost.load(std::memory_order_relaxed) - lost_before;
  now_recording.differences = differences;
  now_recording.taken = steps_taken;
  const double elapsed_s = toSeconds(Clock::now() - worked_since);
  if (elapsed_s > 0.0) now_recording.processor_percent = 100.0 * (threadWork_s() - work_before_s) / elapsed_s;
  if (!commits_ms.empty()) {
    std::vector<double> sorted = commits_ms;
    const auto at = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) * 99 / 100);
    std::nth_element(sorted.begin(), at, sorted.end());
    now_recording.commit_p99_ms = *at;
  }
  const std::lock_guard lock(mutex);
  status = now_recording;
}

}  // namespace fyd::session
