// A whole recorder at the haptic loop's rate, killed at a random moment: of what it says is written, less than the block
// of the next commit is lost; of what was pushed, as much as waits for the recorder's next turn besides.
// FYD_CRASHES=200 sets the full count; without it there are fewer.
#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <random>
#include <thread>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/pipeline/pipeline.h"
#include "core/recording/reader/recording.h"
#include "core/recording/writer/recorder.h"
#include "tests/child_process.h"
#include "tests/unit/recording/recording_samples.h"
#include "tests/wait.h"

namespace fyd::recording {
namespace {

// In steps: a block of 250 that is not committed, 125 that are pushed in the recorder's longest turn, and as much again.
// One kill among several may fall into a standstill of the recorder's thread or of the disk.
constexpr double kMostLost = 750;

/// What the killed process leaves.
struct Left {
  std::atomic<std::int64_t> newest_ns{0};  ///< time of the last step
  std::atomic<std::uint64_t> pushed{0};    ///< steps
  std::atomic<std::uint64_t> written{0};   ///< steps, as the recorder's status said
};

/// Pushes a step each millisecond, a picture each 33, until it is killed. A machine that stands still gets no steps for
/// that time: they are counted against the recorder's thread, not against a clock.
[[noreturn]] void recordForEver(const std::string& file, Left& left) {
  const pipeline::Parameters parameters;
  Recorder recorder({}, parameters, {}, {}, {.profile = [](const auto&) { return std::string(); }, .link = {}});
  pipeline::Pipeline pipeline(parameters);
  recorder.start();
  cv::Mat picture(240, 320, CV_8UC1);
  cv::randu(picture, 0, 255);
  Instant due = Clock::now();
  for (std::uint64_t number = 0;; ++number) {
    due = std::max(due + std::chrono::milliseconds(1), Clock::now());
    std::this_thread::sleep_until(due);
    pipeline::Inputs inputs;
    inputs.now = Clock::now();
    const pipeline::Outputs& outputs = pipeline.step(inputs);
    if (number % 33 == 0) recorder.offerPicture(picture, {40, 45, 220, 150}, {}, inputs.now, number / 33);
    recorder.push({.inputs = inputs, .outputs = outputs});
    left.newest_ns = inputs.now.time_since_epoch().count();
    left.pushed = number + 1;
    left.written = recorder.status().samples;
    if (number == 100 && !recorder.begin({.path = file})) ::_exit(1);
  }
}

TEST(KilledRecorder, LosesLessThanABlockOfWhatIsWrittenAndLittleOfWhatIsPushed) {
  const char* text = std::getenv("FYD_CRASHES");
  const std::size_t crashes = text == nullptr ? 4 : std::strtoul(text, nullptr, 10);
  ASSERT_GT(crashes, 0U);
  void* shared = ::mmap(nullptr, sizeof(Left), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(shared, MAP_FAILED);
  std::mt19937 random(5);
  std::vector<double> lost, lost_s;
  for (std::size_t i = 0; i < crashes; ++i) {
    const samples::Folder folder;
    Left& left = *new (shared) Left;
    ChildProcess child([&]() -> int { recordForEver(folder.file(), left); });
    ASSERT_TRUE(comesTrue("pictures and steps that are committed", [&] {
      const auto growing = Recording::open(folder.file());
      return growing && (*growing)->info().frames > 0U && (*growing)->info().committed_samples >= 500U &&
             left.written > 500U;
    }));
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 500'000));
    ASSERT_EQ(child.kill(), SIGKILL);  // it had not ended by itself
    const auto recording = Recording::open(folder.file());
    ASSERT_TRUE(recording) << recording.error().text();
    const RecordingInfo& info = (*recording)->info();
    EXPECT_GT(info.frames, 0U);
    EXPECT_GE(info.committed_samples + kBlockSteps, left.written.load() + 1) << "each whole block is committed";
    lost.push_back(static_cast<double>(left.pushed.load()) - static_cast<double>(info.committed_samples));
    lost_s.push_back(toSeconds(Duration(left.newest_ns.load())) - toSeconds(info.header.started.time_since_epoch()) -
                     info.duration_s);
  }
  ::munmap(shared, sizeof(Left));
  std::ranges::sort(lost);
  std::ranges::sort(lost_s);
  const std::size_t median = crashes / 2, nearly_all = crashes * 95 / 100;
  std::printf(
      "killed %zu times; lost: median %.0f steps, %.0f ms, 95 %% %.0f steps, %.0f ms, most %.0f steps, %.0f ms\n",
      crashes, lost[median], 1e3 * lost_s[median], lost[nearly_all], 1e3 * lost_s[nearly_all], lost.back(),
      1e3 * lost_s.back());
  EXPECT_LT(lost[(crashes - 1) / 2], kMostLost);
}

}  // namespace
}  // namespace fyd::recording
