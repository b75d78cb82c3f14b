#include "core/recording/writer/recorder.h"

#include <spdlog/spdlog.h>
#include <time.h>

#include <condition_variable>
#include <thread>

#include "core/recording/file/recording_disk.h"
#include "core/recording/writer/live_recording.h"
#include "core/recording/writer/picture_queue.h"
#include "core/recording/writer/step_follower.h"
#include "core/scene/scene_bytes.h"

namespace fyd::recording {
namespace {

constexpr std::chrono::seconds kLongestWait{30};  // for a disk that does not answer

/// Processor time of the calling thread.
double threadWork_s() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// What `begin` and `end` wait for.
struct Answer {
  bool done = false;
  bool abandoned = false;  ///< the caller's wait timed out: what was begun is ended at once
  Result<void> result;
};

}  // namespace

bool isSubjectCode(std::string_view subject) {
  constexpr std::string_view kAllowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
  return subject.size() <= kLongestSubject && subject.find_first_not_of(kAllowed) == std::string_view::npos;
}

Result<void> checkSubject(const std::string& subject) {
  if (isSubjectCode(subject)) return {};
  return fail(
      "subject \"{}\": expected a code of letters, digits, - and _ such as S07, at most {} characters; never a name",
      subject, kLongestSubject);
}

struct Recorder::Impl {
  Impl(const RecorderOptions& chosen, const pipeline::Parameters& step, const pipeline::LocalModel& felt,
       StationDescription words, StationSource asked)
      : options(chosen),
        description(std::move(words)),
        source(std::move(asked)),
        local(felt),
        steps(step, felt, chosen.pre_trigger_s) {}

  const RecorderOptions options;
  const StationDescription description;
  const StationSource source;
  const pipeline::LocalModel local;
  std::shared_ptr<DiskCalls> disk;  // none: the system's

  StepFollower steps;
  PictureQueue pictures;

  // between the operator's thread and the recorder's
  std::mutex mutex;
  std::condition_variable_any asked_for;  // the recorder's thread waits for a request
  std::condition_variable answered;       // the operator's for its answer
  std::optional<RecordingRequest> to_begin;
  std::shared_ptr<Answer> begin_answer;
  std::shared_ptr<Answer> end_answer;
  std::vector<Note> notes;
  bool takes_notes = false;  ///< what is noted now will still be written
  RecorderStatus status;

  // the recorder's thread's own
  std::unique_ptr<LiveRecording> live;
  RecorderStatus now_recording;
  std::uint64_t lost_before = 0;  // the recording, or the thread, began
  Instant worked_since{};
  double work_before_s = 0.0;  // of the processor's time

  std::jthread thread;

  void run(const std::stop_token& stop);
  void write();
  void answerBegin(const RecordingRequest& request, const std::shared_ptr<Answer>& answer);
  void answerEnd(const std::shared_ptr<Answer>& answer);
  [[nodiscard]] Result<void> open(const RecordingRequest& request);
  [[nodiscard]] Result<void> close();
  void closeFull();
  void failed(const Message& problem);
  [[nodiscard]] std::vector<Note> takeNotes(bool last = false);
  void publish();
};

// --- the other threads' side ---

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

void Recorder::push(const StepView& step) noexcept { impl_->steps.push(step); }

void Recorder::offerPicture(const cv::Mat& picture, const cv::Rect& region, const sensing::FingerDetection& finger,
                            Instant taken, std::uint64_t number) {
  impl_->pictures.offer({.picture = picture, .region_px = region, .finger = finger, .taken = taken, .number = number});
}

Result<void> Recorder::begin(const RecordingRequest& request) {
  if (request.path.empty()) return fail("recording: no file name");
  if (auto code = checkSubject(request.subject); !code) return code;
  if (!impl_->thread.joinable()) return fail("{}: the recorder is not running", request.path);
  std::unique_lock lock(impl_->mutex);
  if (impl_->status.state == RecorderState::recording) {
    return fail("{}: {} is still being recorded; stop it first", request.path, impl_->status.path);
  }
  if (impl_->begin_answer) return fail("{}: another recording is being started", request.path);
  auto answer = std::make_shared<Answer>();
  impl_->to_begin = request;
  impl_->begin_answer = answer;
  impl_->asked_for.notify_one();
  if (!impl_->answered.wait_for(lock, kLongestWait, [&] { return answer->done; })) {
    answer->abandoned = true;
    return fail("{}: the disk does not answer; a file that it still makes is closed at once", request.path);
  }
  return answer->result;
}

Result<void> Recorder::end() {
  if (!impl_->thread.joinable()) return fail("the recorder is not running");
  std::unique_lock lock(impl_->mutex);
  if (impl_->status.state != RecorderState::recording) return fail("nothing is being recorded");
  auto answer = impl_->end_answer;
  if (!answer) answer = impl_->end_answer = std::make_shared<Answer>();
  impl_->asked_for.notify_one();
  if (!impl_->answered.wait_for(lock, kLongestWait, [&] { return answer->done; })) {
    return fail("{}: the disk does not answer; the file is closed when it does", impl_->status.path);
  }
  return answer->result;
}

Result<void> Recorder::note(NoteKind kind, const std::string& text) {
  const std::lock_guard lock(impl_->mutex);
  if (!impl_->takes_notes) return fail("{}: not kept, nothing is being recorded", text);
  impl_->notes.push_back({.when = Clock::now(), .kind = kind, .text = text});
  return {};
}

RecorderStatus Recorder::status() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->status;
}

// --- the recorder's thread ---

void Recorder::Impl::run(const std::stop_token& stop) {
  worked_since = Clock::now();
  while (!stop.stop_requested()) {
    std::optional<RecordingRequest> beginning;
    std::shared_ptr<Answer> begins;
    std::shared_ptr<Answer> ends;
    {
      std::unique_lock lock(mutex);
      asked_for.wait_for(lock, stop, live ? live->untilNextTurn() : LiveRecording::kLongestTurn,
                         [this] { return to_begin || end_answer; });
    }
    steps.take();
    pictures.take(steps.oldest());
    {
      const std::lock_guard lock(mutex);
      beginning = std::exchange(to_begin, std::nullopt);
      begins = begin_answer;
      ends = end_answer;
    }
    if (beginning) answerBegin(*beginning, begins);
    if (live) write();
    if (ends) answerEnd(ends);
    publish();
  }
  steps.take();
  pictures.take(steps.oldest());
  if (live) (void)close();  // what fails is logged, and stands in the status
  publish();
}

void Recorder::Impl::write() {
  if (const auto written = live->write(takeNotes()); !written) return failed(written.error().message);
  const auto has_room = live->everySecond(Clock::now());
  if (!has_room) return failed(has_room.error().message);
  if (!*has_room) closeFull();
}

std::vector<Note> Recorder::Impl::takeNotes(bool last) {
  const std::lock_guard lock(mutex);
  if (last) takes_notes = false;
  return std::exchange(notes, {});
}

void Recorder::Impl::answerBegin(const RecordingRequest& request, const std::shared_ptr<Answer>& answer) {
  const Result<void> opened = open(request);
  const std::lock_guard lock(mutex);
  answer->result = opened;
  answer->done = true;
  begin_answer.reset();
  if (opened) {
    notes.clear();
    takes_notes = true;
    status = now_recording;
  }
  answered.notify_all();
  if (answer->abandoned && live) end_answer = std::make_shared<Answer>();
}

void Recorder::Impl::answerEnd(const std::shared_ptr<Answer>& answer) {
  const Result<void> closed = live ? close() : fail(now_recording.problem);
  const std::lock_guard lock(mutex);
  answer->result = closed;
  answer->done = true;
  end_answer.reset();
  status = now_recording;
  answered.notify_all();
}

Result<void> Recorder::Impl::open(const RecordingRequest& request) {
  StepFollower::Start from = steps.start();
  RecordingHeader header{
      .started = from.when,
      .operator_name = request.operator_name,
      .subject = request.subject,
      .notes = request.notes,
      .tags = request.tags,
      .touchpad = description.touchpad,
      .camera = description.camera,
      .robot = description.robot,
      .profile = source.profile(from.parameters),
      .surface = local.surface ? texture::formatSurface(*local.surface) : std::string{},
      .scene = local.scene ? std::make_shared<const std::string>(scene::packScene(*local.scene)) : nullptr,
      .step_state = std::move(from.state),
      .version = FYD_VERSION,
      .lateness = description.lateness};
  // Before the file is made: while a slow disk makes it, the ring may overflow already.
  const std::uint64_t lost_so_far = steps.lost();
  auto opened = LiveRecording::open(
      request.path, std::move(header), options,
      {.steps = steps, .pictures = pictures.history(), .station = source, .lost_before = lost_so_far}, disk);
  if (!opened) return tl::unexpected(opened.error());
  live = std::move(*opened);
  now_recording = {.state = RecorderState::recording};
  lost_before = lost_so_far;
  live->fillIn(now_recording);
  worked_since = Clock::now();
  work_before_s = threadWork_s();
  return {};
}

Result<void> Recorder::Impl::close() {
  if (auto closed = live->close(takeNotes(true)); !closed) {
    failed(closed.error().message);
    return closed;
  }
  live->fillIn(now_recording);
  now_recording.state = RecorderState::idle;
  live.reset();
  return {};
}

void Recorder::Impl::closeFull() {
  const Message why = say("the disk has less than {:.0f} MB left: recording stopped", options.smallest_free_MB);
  const Note alarm{.when = Clock::now(), .kind = NoteKind::alarm, .text = why.text()};
  if (const auto written = live->write({alarm}); !written) return failed(written.error().message);
  if (!close()) return;
  now_recording.state = RecorderState::failed;
  now_recording.problem = say("{}; {} is whole up to here. Make room or choose another disk", why, now_recording.path);
  spdlog::error("Recording: {}", now_recording.problem.text());
}

void Recorder::Impl::failed(const Message& problem) {
  (void)takeNotes(true);
  live->fillIn(now_recording);
  now_recording.state = RecorderState::failed;
  now_recording.problem =
      live->safe()
          ? say("{}. What was written up to {:.1f} s is safe in {}.partial; make it whole with: fyd session recover",
                problem, live->committed_s(), now_recording.path)
          : say("{}. Nothing is promised of {}.partial: another program has removed, replaced or shortened it", problem,
                now_recording.path);
  spdlog::error("Recording: {}", now_recording.problem.text());
  live.reset();
}

void Recorder::Impl::publish() {
  if (live) live->fillIn(now_recording);
  now_recording.lost = steps.lost() - lost_before;
  now_recording.differences = steps.differences();
  now_recording.taken = steps.taken();
  const double elapsed_s = toSeconds(Clock::now() - worked_since);
  if (elapsed_s > 0.0) now_recording.processor_percent = 100.0 * (threadWork_s() - work_before_s) / elapsed_s;
  const std::lock_guard lock(mutex);
  status = now_recording;
}

}  // namespace fyd::recording
