// The recorder's own thread: follows the step, keeps the last seconds, writes.
#include <fmt/chrono.h>
#include <sodium.h>
#include <spdlog/spdlog.h>
#include <time.h>

#include <algorithm>

#include "core/session/recorder_impl.h"
#include "core/session/step_compare.h"

namespace fyd::session {
namespace {

constexpr std::chrono::milliseconds kTurn{20};
constexpr std::size_t kMostSteps = 400;   // a turn: 20 times what comes in
constexpr std::size_t kMostPictures = 4;  // a turn: 6 times what a usual camera gives
constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kMostCommits = 1000;  // 250 s
constexpr double kMB = 1e6;

std::string randomId() {
  std::array<unsigned char, 16> bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  std::string out;
  for (const unsigned char byte : bytes) out += fmt::format("{:02x}", byte);
  return out;
}

/// Processor time of the calling thread.
double ownWork_s() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::string utcOf(Instant when) {
  using std::chrono::system_clock;
  const auto then = system_clock::now() - std::chrono::duration_cast<system_clock::duration>(Clock::now() - when);
  const auto ms = std::chrono::floor<std::chrono::milliseconds>(then.time_since_epoch());
  const std::time_t seconds = std::chrono::duration_cast<std::chrono::seconds>(ms).count();
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(seconds), ms.count() % 1000);
}

}  // namespace

void Recorder::Impl::run(const std::stop_token& stop) {
  worked_since = Clock::now();
  while (!stop.stop_requested()) {
    {
      std::unique_lock lock(mutex);
      asked_for.wait_for(lock, stop, kTurn, [this] { return to_begin || end_answer; });
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
      const Result<void> closed = writer ? close() : fail("{}", now_recording.problem);
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
  if (const auto closed = close(); !closed) spdlog::error("Recording: {}", closed.error().message);
}

void Recorder::Impl::takeSteps() {
  while (ring.read_available() >= packedHeadSize()) {
    ring.pop(packed.data(), packedHeadSize());
    const std::size_t bytes = packedSize(packed);
    ring.pop(packed.data() + packedHeadSize(), bytes - packedHeadSize());  // one push gave both
    const std::span<const std::byte> step(packed.data(), bytes);
    unpackStep(step, record);
    follow();
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

Result<void> Recorder::Impl::open(const RecordingRequest& request) {
  const auto free = freeBytes(request.path);
  if (!free) return tl::unexpected(free.error());
  if (static_cast<double>(*free) < options.smallest_free_MB * kMB) {
    return fail("{}: the disk has {:.0f} MB left, fewer than the {:.0f} MB a recording leaves free", request.path,
                static_cast<double>(*free) / kMB, options.smallest_free_MB);
  }
  const auto from = steps.start();
  header = {.id = randomId(),
            .started = from ? from->when : Clock::now(),
            .operator_name = request.operator_name,
            .subject = request.subject,
            .notes = request.notes,
            .tags = request.tags,
            .touchpad = description.touchpad,
            .camera = description.camera,
            .robot = description.robot,
            .profile = source.profile(from ? from->snapshot->parameters : shadow.parameters()),
            .surface = description.surface,
            .step_state = from ? from->snapshot->state : shadow.saveState(),
            .version = FYD_VERSION};
  header.started_utc = utcOf(header.started);
  auto made = RecordingWriter::create(request.path, header);
  if (!made) return tl::unexpected(made.error());
  writer = std::move(*made);
  steps.readFromStart();
  pictures.readFrom(header.started);
  now_recording = {.state = RecorderState::recording, .path = request.path};
  written_until = header.started;
  lost_before = lost_told = lost.load(std::memory_order_relaxed);
  growth = {};
  commits_ms.clear();
  next_second = worked_since = Clock::now();
  work_before_s = ownWork_s();
  return {};
}

Result<void> Recorder::Impl::write(std::size_t most_steps, std::size_t most_pictures) {
  const std::uint64_t lost_now = lost.load(std::memory_order_relaxed);
  if (lost_now != lost_told) writer->countLost(lost_now - lost_told);
  lost_told = lost_now;
  for (std::size_t i = 0; i < most_steps && steps.read(record); ++i) {
    const std::uint64_t committed = writer->committedSteps();
    const Instant before = Clock::now();
    if (auto written = writer->append(record); !written) return written;
    if (writer->committedSteps() != committed) {
      if (commits_ms.size() == kMostCommits) commits_ms.erase(commits_ms.begin());
      commits_ms.push_back(toMilliseconds(Clock::now() - before));
    }
    ++now_recording.samples;
    written_until = record.inputs.now;
  }
  for (std::size_t i = 0; i < most_pictures; ++i) {
    const auto picture = pictures.read(written_until);
    if (!picture) break;
    if (auto written = writer->append(encodePicture(*picture)); !written) return written;
    ++now_recording.pictures;
  }
  now_recording.pictures_lost = pictures.lost();
  return writeNotes();
}

Result<void> Recorder::Impl::writeNotes() {
  std::vector<Note> taken;
  {
    const std::lock_guard lock(mutex);
    taken.swap(notes);
  }
  for (const Note& note : taken) {
    if (auto written = writer->append(note); !written) return written;
  }
  return {};
}

Result<void> Recorder::Impl::everySecond(Instant now) {
  if (now < next_second) return {};
  next_second = now + std::chrono::seconds(1);
  if (const auto row = source.link ? source.link() : std::nullopt) {
    if (auto written = writer->append(*row); !written) return written;
  }
  growth.observe(now, writer->bytes());
  now_recording.bytes_per_s = growth.bytes_per_s();
  const auto free = freeBytes(now_recording.path);
  if (!free) return tl::unexpected(free.error());
  const double left = static_cast<double>(*free) - options.smallest_free_MB * kMB;
  now_recording.minutes_left =
      now_recording.bytes_per_s > 0.0 ? std::max(0.0, left) / now_recording.bytes_per_s / 60.0 : pipeline::kNone;
  if (left > 0.0) return {};
  const std::string why =
      fmt::format("the disk has less than {:.0f} MB left: recording stopped", options.smallest_free_MB);
  if (auto written = writer->append(Note{.when = now, .kind = NoteKind::alarm, .text = why}); !written) return written;
  if (auto closed = close(); !closed) return closed;
  now_recording.state = RecorderState::failed;
  now_recording.problem =
      fmt::format("{}; {} is whole up to here. Make room or choose another disk", why, now_recording.path);
  spdlog::error("Recording: {}", now_recording.problem);
  return {};
}

Result<void> Recorder::Impl::close() {
  auto closed = write(kAll, kAll);
  if (closed) closed = writer->close();
  if (!closed) {
    failed(closed.error().message);
    return closed;
  }
  now_recording.bytes = writer->bytes();
  now_recording.seconds = toSeconds(written_until - header.started);
  now_recording.state = RecorderState::idle;
  writer.reset();
  steps.stopReading();
  pictures.stopReading();
  return {};
}

void Recorder::Impl::failed(const std::string& problem) {
  now_recording.state = RecorderState::failed;
  now_recording.problem =
      fmt::format("{}. What was written up to {:.1f} s is safe in {}.partial; make it whole with: fyd session recover",
                  problem, static_cast<double>(writer->committedSteps()) * 1e-3, now_recording.path);
  spdlog::error("Recording: {}", now_recording.problem);
  writer.reset();
  steps.stopReading();
  pictures.stopReading();
}

void Recorder::Impl::publish() {
  if (writer) {
    now_recording.bytes = writer->bytes();
    now_recording.seconds = toSeconds(written_until - header.started);
  }
  now_recording.lost = lost.load(std::memory_order_relaxed) - lost_before;
  now_recording.differences = differences;
  const double elapsed_s = toSeconds(Clock::now() - worked_since);
  if (elapsed_s > 0.0) now_recording.processor_percent = 100.0 * (ownWork_s() - work_before_s) / elapsed_s;
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
