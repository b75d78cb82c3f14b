// The recording's file: opening an hour, a window of it, an overview of it; its size beside the bare rows; a commit
// beside plain write() and fdatasync() of as many bytes.
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <opencv2/core.hpp>
#include <random>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/page_run.h"
#include "app/bench/parts/recorded_session.h"
#include "app/bench/parts/table.h"
#include "core/recording/file/recording_disk.h"
#include "core/recording/format/recording_format.h"
#include "core/recording/reader/recording.h"
#include "core/recording/recovery/verify.h"
#include "core/recording/writer/picture_history.h"
#include "core/recording/writer/recording_writer.h"

namespace fyd::bench {
namespace {

using namespace recording;

/// Seconds of the long recording: an hour, of the page ten minutes.
double long_s() { return wholePageOrQuick(3600.0, 600.0, 30.0); }
std::uint64_t commitSteps() { return wholeOrQuick<std::uint64_t>(60'000, 5'000); }
constexpr std::uint64_t kStepsPerPicture = 1'000;
constexpr std::size_t kForceField = 11;

/// Skips fdatasync, so that an hour is recorded in a minute.
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
      const sensing::FingerDetection finger{
          true, 900 + noise(), 190 + noise(), 80 + noise(), 60 + noise(), noise(), noise(), 0.9, {}};
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

/// A picture of a typical camera, with sensor noise.
EncodedPicture aPicture() {
  cv::Mat picture(240, 320, CV_8UC1);
  cv::randn(picture, 200, 4);
  return encodePicture({.picture = picture, .region_px = {40, 45, 220, 150}});
}

/// @return bytes of the file
std::uint64_t makeHour(const std::string& file) {
  auto writer = recording::createRecording(file, header(), std::make_shared<QuickDisk>());
  if (!writer) return 0;
  BusySession steps;
  recording::EncodedPicture picture = aPicture();
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(1e3 * long_s()); ++i) {
    const StepRecord step = steps.next();
    if (!(*writer)->append(step)) return 0;
    if (i % kStepsPerPicture != 0) continue;
    picture.taken = step.inputs.now;
    if (!(*writer)->append(picture)) return 0;
  }
  if (!(*writer)->close()) return 0;
  return std::filesystem::file_size(file);
}

double ms(double ns) { return ns * 1e-6; }

double p95(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() * 95 / 100];
}

/// Wall time, and this thread's processor time: on a busy machine the rest is waiting for other programs. A call says
/// whether it did its work: a refusal is quick.
struct Times {
  std::vector<double> passed_ns;
  std::vector<double> worked_ns;
  std::size_t failed = 0;

  template <class Call>
  void measure(Call&& call) {
    timespec before{};
    timespec after{};
    const auto start = std::chrono::steady_clock::now();
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &before);
    const bool good = call();
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &after);
    if (!good) ++failed;
    passed_ns.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
    worked_ns.push_back(1e9 * static_cast<double>(after.tv_sec - before.tv_sec) +
                        static_cast<double>(after.tv_nsec - before.tv_nsec));
  }
  [[nodiscard]] double p50_ns() const {
    auto sorted = passed_ns;
    return quantiles(sorted).p50;
  }
};

template <class Call>
Times timesOf(int runs, Call&& call) {
  Times out;
  for (int i = 0; i < runs; ++i) out.measure(call);
  return out;
}

std::vector<std::string> rowOf(const char* part, const std::string& name, Times times, const std::string& ratio) {
  const Quantiles q = quantiles(times.passed_ns);
  return {part,
          times.failed == 0 ? name : fmt::format("{} ({} of {} FAILED)", name, times.failed, times.passed_ns.size()),
          number(ms(q.p50)),
          number(ms(p95(times.passed_ns))),
          number(ms(q.p99)),
          number(ms(p95(times.worked_ns))),
          ratio};
}

void addTimes(Table& table, const std::string& name, const Times& times) {
  table.rows.push_back(rowOf("reading", name, times, "—"));
}

void measureReading(Table& table, const std::string& file) {
  addTimes(table, "all of its bytes by read()", timesOf(5, [&] {
             std::ifstream whole(file, std::ios::binary);
             std::vector<char> block(1 << 20);
             while (whole.read(block.data(), static_cast<std::streamsize>(block.size()))) {
             }
             return whole.eof();
           }));
  addTimes(table, "open it", timesOf(20, [&] { return recording::Recording::open(file).has_value(); }));
  const auto opened = recording::Recording::open(file);
  if (!opened) return;
  const recording::Recording& recording = **opened;
  std::mt19937 random(2);
  std::vector<pipeline::TelemetrySample> second(1000);
  addTimes(table, "1 s of telemetry with its picture, anywhere", timesOf(200, [&] {
             const double from_s = std::uniform_real_distribution<double>(1.0, long_s() - 2.0)(random);
             const auto row = recording.rowAt(from_s);
             return row && recording.telemetry(*row, second) && recording.pictureAt(from_s);
           }));
  const auto overview = [&](double seconds) {
    return timesOf(10, [&] {
      const double from_s = std::uniform_real_distribution<double>(0.0, long_s() - seconds)(random);
      // Opened anew each time: nothing is in the reader's own cache.
      const auto fresh = recording::Recording::open(file);
      return fresh && (*fresh)->overview(kForceField, from_s, from_s + seconds, 1000);
    });
  };
  addTimes(table, "open, then all of it in 1000 buckets", overview(long_s()));
  for (const double seconds : {600.0, 180.0, 20.0}) {
    if (seconds < long_s())
      addTimes(table, fmt::format("open, then {:g} s in 1000 buckets", seconds), overview(seconds));
  }
  const std::uint64_t rows = recording.info().committed_samples;
  std::uint64_t row = 0;
  addTimes(table, "1000 steps in order, for replay", timesOf(100, [&] {
             for (int i = 0; i < 1000; ++i, row = (row + 1) % rows) {
               if (!recording.step(row)) return false;
             }
             return true;
           }));
}

void measureCommits(Table& table, const TemporaryFolder& folder) {
  auto writer = RecordingWriter::create(folder.file("commits.h5"), header());
  if (!writer) return;
  BusySession steps;
  Times times;
  const std::uint64_t before = (*writer)->bytes();
  for (std::uint64_t i = 1; i <= commitSteps(); ++i) {
    const StepRecord record = steps.next();
    Result<void> put;
    if (i % kBlockSteps == 0)
      times.measure([&] {
        put = (*writer)->append(record);
        return put.has_value();
      });
    else
      put = (*writer)->append(record);
    if (!put) return;
  }
  const std::vector<char> bytes(((*writer)->bytes() - before) / times.passed_ns.size());
  const int plain = ::open(folder.file("plain").c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
  const Times plain_times = timesOf(static_cast<int>(times.passed_ns.size()), [&] {
    return ::write(plain, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()) && ::fdatasync(plain) == 0;
  });
  ::close(plain);
  const double ratio = times.p50_ns() / plain_times.p50_ns();
  table.rows.push_back(rowOf("a commit", fmt::format("baseline: write() and fdatasync() of {} kB", bytes.size() / 1000),
                             plain_times, "1"));
  table.rows.push_back(rowOf("a commit", "250 steps", times, number(ratio)));
}

}  // namespace

Table bench_recording() {
  Table table{.subject = "recording",
              .title = "The recording's file",
              .columns = {{"part", Role::group},
                          {"what", Role::method},
                          {"p50", "ms", Role::cost},
                          {"p95", "ms"},
                          {"p99", "ms"},
                          {"processor p95", "ms"},
                          "p50 against the baseline"},
              .rows = {},
              .notes = {}};
  const TemporaryFolder folder;
  const std::string hour = folder.file("hour.h5");
  const std::uint64_t bytes = makeHour(hour);
  measureReading(table, hour);
  measureCommits(table, folder);
  const auto start = std::chrono::steady_clock::now();
  const auto verified = recording::verify(hour);
  const double verify_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (verified)
    table.notes.push_back(fmt::format(
        "{:g} s of steps, with a picture a second: {} MB, its rows without compression {} MB ({} of them); verify "
        "reads all "
        "of "
        "it in {} s and finds {} damaged blocks.",
        long_s(), number(static_cast<double>(bytes) * 1e-6, 4), number(static_cast<double>(verified->bytes) * 1e-6, 4),
        number(static_cast<double>(bytes) / static_cast<double>(verified->bytes)), number(verify_s),
        verified->damaged));
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  table.notes.push_back(fmt::format("The process never took more than {} MB of memory, writing and reading.",
                                    number(static_cast<double>(used.ru_maxrss) * 1024e-6)));
  table.notes.push_back(
      "The session is synthetic: texture and accelerations are noise, which does not compress. The operating system "
      "may "
      "have the file in its memory; a cold disk adds its own time.");
  table.notes.push_back("A commit compresses, waits for the disk twice (rows, then journal) and is all or nothing.");
  return table;
}

}  // namespace fyd::bench
