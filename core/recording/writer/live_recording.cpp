#include "core/recording/writer/live_recording.h"

#include <fmt/chrono.h>
#include <sodium.h>

#include <algorithm>
#include <array>

#include "core/recording/format/recording_format.h"

namespace fyd::recording {
namespace {

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kMostSteps = 400;     // a turn
constexpr std::size_t kMostPictures = 8;    // a turn: twice what a usual camera gives
constexpr std::size_t kMostCommits = 1000;  // 250 s
constexpr double kMB = 1e6;
constexpr std::chrono::milliseconds kShortestTurn{10};
// While it writes what was kept from before the start: in small portions, so that it does not starve other threads.
constexpr std::chrono::milliseconds kTurnBehind{20};

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

Result<std::unique_ptr<LiveRecording>> LiveRecording::open(const std::string& path, RecordingHeader header,
                                                           const RecorderOptions& options, Sources sources,
                                                           std::shared_ptr<DiskCalls> disk) {
  const auto free = freeBytes(path);
  if (!free) return tl::unexpected(free.error());
  if (static_cast<double>(*free) < options.smallest_free_MB * kMB) {
    return fail("{}: the disk has {:.0f} MB left, fewer than the {:.0f} MB a recording leaves free", path,
                static_cast<double>(*free) / kMB, options.smallest_free_MB);
  }
  header.id = randomId();
  header.started_utc = utcOf(header.started);
  auto made = createRecording(path, header, std::move(disk));
  if (!made) return tl::unexpected(made.error());
  return std::unique_ptr<LiveRecording>(new LiveRecording(path, std::move(header), options, sources, std::move(*made)));
}

LiveRecording::LiveRecording(std::string path, RecordingHeader header, const RecorderOptions& options, Sources sources,
                             std::unique_ptr<RecordingWriter> writer)
    : path_(std::move(path)),
      header_(std::move(header)),
      options_(options),
      sources_(sources),
      writer_(std::move(writer)),
      written_until_(header_.started),
      committed_until_(header_.started),
      lost_told_(sources_.lost_before),
      next_second_(Clock::now()) {
  sources_.steps.history().readFromStart();
  sources_.pictures.readFrom(header_.started);
}

LiveRecording::~LiveRecording() {
  sources_.steps.history().stopReading();
  sources_.pictures.stopReading();
}

Result<void> LiveRecording::write(const std::vector<Note>& notes) { return write(kMostSteps, kMostPictures, notes); }

Result<void> LiveRecording::write(std::size_t most_steps, std::size_t most_pictures, const std::vector<Note>& notes) {
  const std::uint64_t lost_now = sources_.steps.lost();
  if (lost_now != lost_told_) writer_->countLost(lost_now - lost_told_);
  lost_told_ = lost_now;
  std::size_t taken = 0;
  for (; taken < most_steps && sources_.steps.history().read(record_); ++taken) {
    const std::uint64_t committed = writer_->committedSteps();
    const Instant before = Clock::now();
    if (auto written = writer_->append(record_); !written) return written;
    if (writer_->committedSteps() != committed) {
      committed_until_ = record_.inputs.now;
      if (commits_ms_.size() == kMostCommits) commits_ms_.erase(commits_ms_.begin());
      commits_ms_.push_back(toMilliseconds(Clock::now() - before));
    }
    ++samples_;
    written_until_ = record_.inputs.now;
  }
  std::size_t seen = 0;
  for (; seen < most_pictures; ++seen) {
    const auto picture = sources_.pictures.read(written_until_);
    if (!picture) break;
    if (auto written = writer_->append(encodePicture(*picture, wholeIsDue(*picture))); !written) return written;
    ++pictures_;
  }
  behind_ = taken == most_steps || seen == most_pictures;
  for (const Note& note : notes) {
    if (auto written = writer_->append(note); !written) return written;
  }
  return {};
}

// JPEG takes half a millisecond: for every picture it would be a third of this thread's work.
bool LiveRecording::wholeIsDue(const HeldPicture& picture) {
  constexpr std::chrono::milliseconds kUnevenness{10};  // jitter of a camera's rate
  const Duration since = picture.taken - newest_whole_;
  const bool soon = since > Duration::zero() && since + kUnevenness < fromSeconds(1.0 / options_.whole_pictures_Hz);
  if (soon && ++without_whole_ <= kFarthestWhole) return false;
  without_whole_ = 0;
  newest_whole_ = picture.taken;
  return true;
}

Result<bool> LiveRecording::everySecond(Instant now) {
  if (now < next_second_) return true;
  next_second_ = now + std::chrono::seconds(1);
  if (const auto row = sources_.station.link ? sources_.station.link() : std::nullopt) {
    if (auto written = writer_->append(*row); !written) return tl::unexpected(written.error());
  }
  if (!behind_) growth_.observe(now, writer_->bytes());  // the burst of pre-trigger data is not counted as growth
  const auto free = freeBytes(path_, writer_->bytes());
  if (!free) return tl::unexpected(free.error());
  // Two looks at the file's entry: a removed one takes every write, and nobody would know until it is closed.
  if (auto same = writer_->checkSafe(); !same) return tl::unexpected(same.error());
  const double left = static_cast<double>(*free) - options_.smallest_free_MB * kMB;
  const double bytes_per_s = growth_.bytes_per_s();
  minutes_left_ = bytes_per_s > 0.0 ? std::max(0.0, left) / bytes_per_s / 60.0 : pipeline::kNone;
  return left > 0.0;
}

Result<void> LiveRecording::close(const std::vector<Note>& notes) {
  if (auto written = write(kAll, kAll, notes); !written) return written;
  return writer_->close();
}

// A turn ends when the next commit is due, so that nothing waits for it longer than its own 250 steps.
std::chrono::milliseconds LiveRecording::untilNextTurn() const {
  if (behind_) return kTurnBehind;
  const std::chrono::milliseconds until_commit(kBlockSteps - samples_ % kBlockSteps + 1);
  return std::clamp(until_commit, kShortestTurn, kLongestTurn);
}

void LiveRecording::fillIn(RecorderStatus& status) const {
  status.path = path_;
  status.seconds = toSeconds(written_until_ - header_.started);
  status.bytes = writer_->bytes();
  status.bytes_per_s = growth_.bytes_per_s();
  status.minutes_left = minutes_left_;
  status.samples = samples_;
  status.pictures = pictures_;
  status.pictures_lost = sources_.pictures.lost();
  if (commits_ms_.empty()) return;
  std::vector<double> sorted = commits_ms_;
  const auto at = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) * 99 / 100);
  std::ranges::nth_element(sorted, at);
  status.commit_p99_ms = *at;
}

}  // namespace fyd::recording
