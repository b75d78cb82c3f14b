// The recorder's file: opened, filled, closed, and what happens when the disk is full or gone.
#include <fmt/chrono.h>
#include <sodium.h>
#include <spdlog/spdlog.h>
#include <time.h>

#include <algorithm>

#include "core/scene/scene_bytes.h"
#include "core/session/recorder_impl.h"

namespace fyd::session {
namespace {

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

std::string utcOf(Instant when) {
  using std::chrono::system_clock;
  const auto then = system_clock::now() - std::chrono::duration_cast<system_clock::duration>(Clock::now() - when);
  const auto ms = std::chrono::floor<std::chrono::milliseconds>(then.time_since_epoch());
  const std::time_t seconds = std::chrono::duration_cast<std::chrono::seconds>(ms).count();
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(seconds), ms.count() % 1000);
}

}  // namespace

double threadWork_s() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
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
            .surface = local.surface ? texture::formatSurface(*local.surface) : std::string{},
            .scene = local.scene ? std::make_shared<const std::string>(scene::packScene(*local.scene)) : nullptr,
            .step_state = from ? from->snapshot->state : shadow.saveState(),
            .version = FYD_VERSION};
  header.started_utc = utcOf(header.started);
  auto made = createRecording(request.path, header, disk);
  if (!made) return tl::unexpected(made.error());
  writer = std::move(*made);
  steps.readFromStart();
  pictures.readFrom(header.started);
  now_recording = {.state = RecorderState::recording, .path = request.path};
  written_until = header.started;
  lost_before = lost_told = lost.load(std::memory_order_relaxed);
  growth = {};
  newest_whole = {};
  commits_ms.clear();
  next_second = worked_since = Clock::now();
  work_before_s = threadWork_s();
  return {};
}

Result<void> Recorder::Impl::write(std::size_t most_steps, std::size_t most_pictures) {
  const std::uint64_t lost_now = lost.load(std::memory_order_relaxed);
  if (lost_now != lost_told) writer->countLost(lost_now - lost_told);
  lost_told = lost_now;
  std::size_t taken = 0;
  for (; taken < most_steps && steps.read(record); ++taken) {
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
  std::size_t seen = 0;
  for (; seen < most_pictures; ++seen) {
    const auto picture = pictures.read(written_until);
    if (!picture) break;
    if (auto written = writer->append(encodePicture(*picture, wholeIsDue(*picture))); !written) return written;
    ++now_recording.pictures;
  }
  behind = taken == most_steps || seen == most_pictures;
  now_recording.pictures_lost = pictures.lost();
  return writeNotes();
}

// Half a millisecond of JPEG for each picture would be a third of this thread's work; the region comes with every one.
bool Recorder::Impl::wholeIsDue(const HeldPicture& picture) {
  constexpr std::chrono::milliseconds kUnevenness{10};  // of a camera's pace
  const Duration since = picture.taken - newest_whole;
  if (since > Duration::zero() && since + kUnevenness < fromSeconds(1.0 / options.whole_pictures_Hz)) return false;
  newest_whole = picture.taken;
  return true;
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
  if (!behind) growth.observe(now, writer->bytes());  // what was kept from before the start goes in at once
  now_recording.bytes_per_s = growth.bytes_per_s();
  const auto free = freeBytes(now_recording.path, writer->bytes());
  if (!free) return tl::unexpected(free.error());
  const double left = static_cast<double>(*free) - options.smallest_free_MB * kMB;
  now_recording.minutes_left =
      now_recording.bytes_per_s > 0.0 ? std::max(0.0, left) / now_recording.bytes_per_s / 60.0 : pipeline::kNone;
  if (left > 0.0) return {};
  const Message why = say("the disk has less than {:.0f} MB left: recording stopped", options.smallest_free_MB);
  if (auto written = writer->append(Note{.when = now, .kind = NoteKind::alarm, .text = why.text()}); !written)
    return written;
  if (auto closed = close(); !closed) return closed;
  now_recording.state = RecorderState::failed;
  now_recording.problem = say("{}; {} is whole up to here. Make room or choose another disk", why, now_recording.path);
  spdlog::error("Recording: {}", now_recording.problem.text());
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

void Recorder::Impl::failed(const Message& problem) {
  now_recording.state = RecorderState::failed;
  now_recording.problem =
      say("{}. What was written up to {:.1f} s is safe in {}.partial; make it whole with: fyd session recover", problem,
          static_cast<double>(writer->committedSteps()) * 1e-3, now_recording.path);
  spdlog::error("Recording: {}", now_recording.problem.text());
  writer.reset();
  steps.stopReading();
  pictures.stopReading();
}

}  // namespace fyd::session
