// Overviews lose no spike, times find their rows, and a recording that grows in another process can be followed.
#include <unistd.h>

#include <array>
#include <chrono>

#include <gtest/gtest.h>

#include "core/recording/file/recording_disk.h"
#include "core/recording/file/recording_place.h"
#include "core/recording/writer/recording_writer.h"
#include "recording_samples.h"
#include "tests/child_process.h"
#include "tests/wait.h"

namespace fyd::recording {
namespace {

using namespace samples;

constexpr std::size_t kForce = 11;

/// A disk that promises and does not wait: for long recordings.
class QuickDisk final : public DiskCalls {
 public:
  int sync(int) override { return 0; }
};

/// Noise, stretches without a number, and single spikes.
std::vector<double> forces(std::size_t rows) {
  std::mt19937 random(9);
  std::normal_distribution<double> noise;
  std::vector<double> out(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    out[i] = noise(random);
    if (i % 9000 > 8000) out[i] = pipeline::kNone;
    if (random() % 5000 == 0) out[i] = 1000.0 + static_cast<double>(i);
  }
  return out;
}

std::unique_ptr<Recording> recorded(const std::string& file, const std::vector<double>& values) {
  auto writer = createRecording(file, header(), std::make_shared<QuickDisk>());
  EXPECT_TRUE(writer);
  for (std::size_t i = 0; i < values.size(); ++i) {
    StepRecord record = plainStep(i);
    record.telemetry.force_N = values[i];
    EXPECT_TRUE((*writer)->append(record));
    if (i == 777) {  // a short block must not put the levels out of step
      EXPECT_TRUE((*writer)->commit());
    }
  }
  EXPECT_TRUE((*writer)->close());
  auto recording = Recording::open(file);
  EXPECT_TRUE(recording);
  return recording ? std::move(*recording) : nullptr;
}

MinMax extremes(const std::vector<double>& values, std::size_t first, std::size_t end) {
  MinMax out;
  for (std::size_t i = first; i < end; ++i) {
    out.low = std::fmin(out.low, values[i]);
    out.high = std::fmax(out.high, values[i]);
  }
  return out;
}

bool equal(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

TEST(RecordingOverview, IsExactlyTheExtremesOfItsBuckets) {
  const Folder folder;
  const std::vector<double> values = forces(141'333);
  const auto recording = recorded(folder.file(), values);
  ASSERT_TRUE(recording);
  std::mt19937 random(10);
  for (int i = 0; i < 60; ++i) {
    const std::size_t first = i == 0 ? 0 : random() % values.size();
    const std::size_t rows = i == 0 ? values.size() : 1 + random() % (values.size() >> (random() % 12));
    const std::size_t end = std::min(values.size(), first + rows);
    const std::size_t buckets = std::array{1U, 2U, 7U, 100U, 1000U, 3000U}[random() % 6];
    const auto overview = recording->overview(kForce, static_cast<double>(first) / 1000.0,
                                              static_cast<double>(end - 1) / 1000.0, buckets);
    ASSERT_TRUE(overview) << overview.error().text();
    ASSERT_LE(overview->values.size(), buckets);
    ASSERT_EQ(overview->values.size(), overview->time_s.size());
    for (std::size_t b = 0; b < overview->values.size(); ++b) {
      const auto from = static_cast<std::size_t>(std::llround(overview->time_s[b] * 1000.0));
      const std::size_t to = b + 1 < overview->time_s.size()
                                 ? static_cast<std::size_t>(std::llround(overview->time_s[b + 1] * 1000.0))
                                 : end;
      if (b == 0) {
        ASSERT_EQ(from, first);
      }
      const MinMax wanted = extremes(values, from, to);
      ASSERT_TRUE(equal(overview->values[b].low, wanted.low) && equal(overview->values[b].high, wanted.high))
          << "rows " << from << " to " << to << " of " << first << " to " << end << " in " << buckets;
    }
  }
}

TEST(RecordingOverview, OddQuestionsHaveAnswers) {
  const Folder folder;
  const auto recording = recorded(folder.file(), forces(1000));
  ASSERT_TRUE(recording);
  EXPECT_TRUE(recording->overview(kForce, 0, 1, 0)->values.empty());
  EXPECT_TRUE(recording->overview(kForce, 5, 9, 10)->values.empty());
  EXPECT_TRUE(recording->overview(kForce, 0.8, 0.2, 10)->values.empty());
  EXPECT_EQ(recording->overview(kForce, -INFINITY, INFINITY, 5000)->values.size(), 1000U);
  EXPECT_EQ(recording->overview(kForce, -INFINITY, INFINITY, ~std::size_t{0})->values.size(), 1000U);
  EXPECT_FALSE(recording->overview(kForce, NAN, 1, 10));
  EXPECT_FALSE(recording->overview(1000, 0, 1, 10));
  EXPECT_FALSE(recording->rowAt(NAN));
  EXPECT_EQ(*recording->rowAt(-3.0), 0U);
  EXPECT_EQ(*recording->rowAt(0.5), 500U);
  EXPECT_EQ(*recording->rowAt(0.5001), 501U);
  EXPECT_EQ(*recording->rowAt(0.999), 999U);
  EXPECT_EQ(*recording->rowAt(1e9), 1000U);
  EXPECT_FALSE(recording->step(1000));
  std::vector<double> three(3);
  EXPECT_FALSE(recording->field(kForce, 998, three));
  EXPECT_FALSE(recording->field(kForce, ~std::uint64_t{0}, three));
  EXPECT_TRUE(recording->field(kForce, 1000, {}));
  EXPECT_FALSE(recording->picture(0));
}

TEST(RecordingOverview, AClockSetBackAndTheCountersOfAnOldLoopAreNoTrouble) {
  const Folder folder;
  auto writer = createRecording(folder.file(), header(), std::make_shared<QuickDisk>());
  ASSERT_TRUE(writer);
  const std::uint64_t start = (std::uint64_t{1} << 32) - 500;
  for (std::uint64_t row = 0; row < 1500; ++row) {
    StepRecord record = plainStep(row);
    record.telemetry.step = start + row;
    record.inputs.missed_cycles = start * 3 + row;
    if (row >= 700) record.telemetry.now -= std::chrono::milliseconds(400);  // back to 0.300 s
    ASSERT_TRUE((*writer)->append(record));
  }
  ASSERT_TRUE((*writer)->close());
  const auto recording = Recording::open(folder.file());
  ASSERT_TRUE(recording);
  EXPECT_EQ((*recording)->info().gaps, 0U);
  EXPECT_EQ(*(*recording)->rowAt(0.4), 400U);   // the first of two
  EXPECT_EQ(*(*recording)->rowAt(0.8), 1200U);  // only after the clock came round again
  EXPECT_EQ(*(*recording)->rowAt(1.2), 1500U);
  EXPECT_EQ((*recording)->step(1400)->telemetry.step, start + 1400);
  EXPECT_EQ((*recording)->step(1400)->inputs.missed_cycles, start * 3 + 1400);
  EXPECT_NEAR((*recording)->info().duration_s, 1.099, 1e-9);
}

TEST(RecordingOverview, AGrowingRecordingIsFollowedFromAnotherProcess) {
  const Folder folder;
  std::array<int, 2> seen_half{};
  ASSERT_EQ(::pipe(seen_half.data()), 0);
  ChildProcess child([&] {
    ::close(seen_half[1]);
    auto writer = createRecording(folder.file(), header(), std::make_shared<QuickDisk>());
    if (!writer) return 1;
    for (std::uint64_t row = 0; row < 20'000; ++row) {
      char word = 0;  // half of it is looked at before the rest is written, however late the reader is
      if (row == 10'000 && ::read(seen_half[0], &word, 1) != 1) return 4;
      if (!(*writer)->append(plainStep(row))) return 2;
    }
    return (*writer)->close() ? 0 : 3;
  });
  std::unique_ptr<Recording> recording;
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (!recording && std::chrono::steady_clock::now() < deadline)
    if (auto opened = Recording::open(folder.file()); opened) recording = std::move(*opened);
  ASSERT_TRUE(recording);
  std::uint64_t seen = 0;
  std::size_t looks = 0;
  while (recording->info().wholeness != Wholeness::whole && std::chrono::steady_clock::now() < deadline) {
    // While its writer is writing, a read may fail; it must never give a wrong row.
    if (!recording->refresh()) continue;
    const std::uint64_t rows = recording->info().committed_samples;
    ASSERT_GE(rows, seen);
    if (rows == seen) continue;
    for (std::uint64_t row = seen; row < rows; row += 61)
      if (const auto step = recording->step(row); step) {
        ASSERT_TRUE(sameRecord(*step, plainStep(row))) << row;
      }
    if (seen == 0) {
      ASSERT_EQ(::write(seen_half[1], "", 1), 1);
    }
    seen = rows;
    ++looks;
  }
  ::close(seen_half[1]);
  ::close(seen_half[0]);
  EXPECT_EQ(child.wait(), 0);
  EXPECT_EQ(recording->info().wholeness, Wholeness::whole);
  EXPECT_EQ(recording->info().committed_samples, 20'000U);
  EXPECT_GT(looks, 1U);
  EXPECT_TRUE(sameRecord(*recording->step(19'999), plainStep(19'999)));
}

TEST(RecordingOverview, AGrowingRecordingIsReadInItsOwnProcess) {
  const Folder folder;
  auto writer = RecordingWriter::create(folder.file(), header());
  ASSERT_TRUE(writer);
  const auto recording = Recording::open(folder.file());
  ASSERT_TRUE(recording) << recording.error().text();
  for (std::uint64_t row = 0; row < 1000; ++row) {
    ASSERT_TRUE((*writer)->append(plainStep(row)));
    if (row % 250 != 249) continue;
    const auto news = (*recording)->refresh();
    ASSERT_TRUE(news) << news.error().text();
    EXPECT_TRUE(*news);
    EXPECT_EQ((*recording)->info().committed_samples, row + 1);
    EXPECT_EQ((*recording)->info().wholeness, Wholeness::growing);
    EXPECT_TRUE(sameRecord(*(*recording)->step(row), plainStep(row)));
  }
  ASSERT_TRUE((*writer)->close());
  ASSERT_TRUE((*recording)->refresh());
  EXPECT_EQ((*recording)->info().wholeness, Wholeness::whole);
}

}  // namespace
}  // namespace fyd::recording
