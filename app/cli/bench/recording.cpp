// The recording's file: opening an hour, a window of it, an overview of it; its size beside the bare rows; a commit
// beside plain write() and fdatasync() of as many bytes.
#include <fcntl.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "app/cli/bench/recorded_session.h"
#include "app/cli/bench/table.h"
#include "core/session/recording.h"
#include "core/session/recording_writer_on_disk.h"
#include "core/session/verify.h"

namespace fyd::bench {
namespace {

using namespace session;

constexpr std::uint64_t kHourSteps = 3'600'000;
constexpr std::uint64_t kCommitSteps = 60 * 1000;
constexpr std::size_t kForceField = 11;

/// Promises and does not wait, so that an hour is made in a minute.
class QuickDisk final : public DiskCalls {
 public:
  int sync(int) override { return 0; }
};

RecordingHeader header() {
  RecordingHeader header;
  header.id = std::string(32, '0');
  header.started = instantAt(1000.0);
  return header;
}

/// A busy session: a finger at 30 Hz, distances at 38 Hz, bridge at 80 Hz, motors and robot at 1 kHz, texture always.
class BusySession {
 public:
  StepRecord next() {
    StepRecord r;
    const double t_s = static_cast<double>(row_) * 1e-3;
    const Instant now = instantAt(1000.0) + std::chrono::milliseconds(row_);
    in_.now = now;
    in_.robot.phase = pipeline::LinkPhase::running;
    if (row_ % 33 == 0) {
      const sensing::FingerDetection finger{true, 900 + noise(), 80 + noise(), 60 + noise(), noise(), noise(), 0.9, {}};
      in_.finger.set(finger, now);
    }
    if (row_ % 26 == 0) in_.ir.set({{1800, 1900, 2000}, 3}, now);
    if (row_ % 12 == 0) in_.bridge.set({0.4 + 0.01 * noise()}, now);
    in_.motors.set({{2000, 2100}, {std::round(100 * noise()), std::round(100 * noise())}, {}, false}, now);
    in_.robot.state.set({0.6, {10 * std::sin(t_s), 5 * std::cos(t_s), -2}, false}, now);
    in_.robot.accelerations.clear();
    (void)in_.robot.accelerations.push({now, {noise(), noise(), noise()}});
    r.inputs = in_;
    pipeline::TelemetrySample& s = r.telemetry;
    s.now = now;
    s.step = ++row_;
    s.state = pipeline::SafetyState::active;
    s.force_N = 2 + std::sin(t_s) + 0.01 * noise();
    s.indentation_mm = 3 + std::sin(t_s) + 0.005 * noise();
    s.stiffness_N_per_mm = s.force_N / s.indentation_mm;
    s.texture_signal_g = noise();
    s.vibration_duty_percent = 10 * s.texture_signal_g;
    s.touch_x_mm = 10 * std::sin(t_s);
    s.touch_y_mm = 5 * std::cos(t_s);
    s.touch_z_mm = -s.indentation_mm;
    s.acceleration_x_g = noise();
    s.acceleration_y_g = noise();
    s.acceleration_z_g = noise();
    s.bridge_age_ms = static_cast<double>(row_ % 12);
    s.ir_age_ms = static_cast<double>(row_ % 26);
    s.finger_age_ms = static_cast<double>(row_ % 33);
    r.motors = {{static_cast<std::int16_t>(1000 * std::sin(t_s)), 0}, {s.vibration_duty_percent, 0}, true};
    return r;
  }

 private:
  double noise() { return noise_(random_); }
  std::mt19937 random_{1};
  std::normal_distribution<double> noise_;
  pipeline::Inputs in_;
  std::uint64_t row_ = 0;
};

/// @return bytes of the file
std::uint64_t makeHour(const std::string& file) {
  auto writer = createRecording(file, header(), std::make_shared<QuickDisk>());
  if (!writer) return 0;
  BusySession steps;
  for (std::uint64_t i = 0; i < kHourSteps; ++i)
    if (!(*writer)->append(steps.next())) return 0;
  if (!(*writer)->close()) return 0;
  return std::filesystem::file_size(file);
}

void addTimes(Table& table, const std::string& name, std::vector<double> times_ns) {
  const Quantiles q = quantiles(times_ns);
  table.rows.push_back({name, number(q.p50 * 1e-6), number(q.p99 * 1e-6), "—"});
}

void measureReading(Table& table, const std::string& file) {
  addTimes(table, "open an hour", timeEach(20, [&] { (void)Recording::open(file); }));
  const auto opened = Recording::open(file);
  if (!opened) return;
  const Recording& recording = **opened;
  std::mt19937 random(2);
  std::vector<pipeline::TelemetrySample> second(1000);
  addTimes(table, "telemetry of 1 s, anywhere",
           timeEach(200, [&] { (void)recording.telemetry(random() % (kHourSteps - second.size()), second); }));
  const auto overview = [&](double seconds) {
    return timeEach(10, [&] {
      const double from_s = std::uniform_real_distribution<double>(0.0, 3600.0 - seconds)(random);
      // Opened anew each time: nothing is in the reader's own cache.
      if (const auto fresh = Recording::open(file); fresh)
        (void)(*fresh)->overview(kForceField, from_s, from_s + seconds, 1000);
    });
  };
  addTimes(table, "open, then 1 h in 1000 buckets", overview(3600));
  addTimes(table, "open, then 10 min in 1000 buckets", overview(600));
  addTimes(table, "open, then 3 min in 1000 buckets", overview(180));
  addTimes(table, "open, then 20 s in 1000 buckets", overview(20));
  std::uint64_t row = 0;
  addTimes(table, "1000 steps in order, for replay", timeEach(100, [&] {
             for (int i = 0; i < 1000; ++i) (void)recording.step(row++);
           }));
}

void measureCommits(Table& table, const TemporaryFolder& folder) {
  auto writer = RecordingWriter::create(folder.file("commits.h5"), header());
  if (!writer) return;
  BusySession steps;
  std::vector<double> times;
  const std::uint64_t before = (*writer)->bytes();
  for (std::uint64_t i = 1; i <= kCommitSteps; ++i) {
    const StepRecord record = steps.next();
    const auto start = std::chrono::steady_clock::now();
    if (!(*writer)->append(record)) return;
    if (i % kBlockSteps == 0)
      times.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
  }
  const std::vector<char> bytes(((*writer)->bytes() - before) / times.size());
  const int plain = ::open(folder.file("plain").c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
  std::vector<double> plain_times = timeEach(static_cast<int>(times.size()), [&] {
    (void)!::write(plain, bytes.data(), bytes.size());
    ::fdatasync(plain);
  });
  ::close(plain);
  const Quantiles ours = quantiles(times);
  const Quantiles theirs = quantiles(plain_times);
  table.rows.push_back({fmt::format("baseline: write() and fdatasync() of {} kB", bytes.size() / 1000),
                        number(theirs.p50 * 1e-6), number(theirs.p99 * 1e-6), "1"});
  table.rows.push_back(
      {"a commit of 250 steps", number(ours.p50 * 1e-6), number(ours.p99 * 1e-6), number(ours.p50 / theirs.p50)});
}

}  // namespace

Table bench_recording() {
  Table table{.subject = "recording",
              .title = "The recording's file",
              .columns = {"what", "p50 (ms)", "p99 (ms)", "p50 against the baseline"},
              .rows = {},
              .notes = {}};
  const TemporaryFolder folder;
  const std::string hour = folder.file("hour.h5");
  const std::uint64_t bytes = makeHour(hour);
  measureReading(table, hour);
  measureCommits(table, folder);
  const auto start = std::chrono::steady_clock::now();
  const auto verified = verify(hour);
  const double verify_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (verified)
    table.notes.push_back(fmt::format(
        "An hour of steps without pictures: {} MB, its rows without compression {} MB ({} of them); verify reads all "
        "of "
        "it in {} s and finds {} damaged blocks.",
        number(static_cast<double>(bytes) * 1e-6, 4), number(static_cast<double>(verified->bytes) * 1e-6, 4),
        number(static_cast<double>(bytes) / static_cast<double>(verified->bytes)), number(verify_s),
        verified->damaged));
  table.notes.push_back(
      "The hour is synthetic: texture and accelerations are noise, which does not compress. The operating system may "
      "have the file in its memory; a cold disk adds its own time.");
  table.notes.push_back("A commit compresses, waits for the disk twice (rows, then journal) and is all or nothing.");
  return table;
}

}  // namespace fyd::bench
