// A whole recorder at the haptic loop's rate, killed at a random moment: how many of the pushed steps are lost.
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

// Far above the 0.3 s that the format promises: the machine of a test may do anything. For the same reason one kill
// among several may fall into a standstill of the recorder's thread or of the disk.
constexpr double kMostLost_s = 1.5;

/// Pushes a step each millisecond, a picture each 33, until it is killed. @param newest_ns where the last step's time
/// goes
[[noreturn]] void recordForEver(const std::string& file, std::atomic<std::int64_t>& newest_ns) {
  const pipeline::Parameters parameters;
  Recorder recorder({}, parameters, {}, {}, {.profile = [](const auto&) { return std::string(); }, .link = {}});
  pipeline::Pipeline pipeline(parameters);
  recorder.start();
  cv::Mat picture(240, 320, CV_8UC1);
  cv::randu(picture, 0, 255);
  Instant due = Clock::now();
  for (std::uint64_t number = 0;; ++number) {
    std::this_thread::sleep_until(due += std::chrono::milliseconds(1));
    pipeline::Inputs inputs;
    inputs.now = Clock::now();
    const pipeline::Outputs& outputs = pipeline.step(inputs);
    if (number % 33 == 0) recorder.offerPicture(picture, {40, 45, 220, 150}, {}, inputs.now, number / 33);
    recorder.push({.inputs = inputs, .outputs = outputs});
    newest_ns = inputs.now.time_since_epoch().count();
    if (number == 100 && !recorder.begin({.path = file})) ::_exit(1);
  }
}

TEST(KilledRecorder, LosesAFractionOfASecond) {
  const char* text = std::getenv("FYD_CRASHES");
  const std::size_t crashes = text == nullptr ? 4 : std::strtoul(text, nullptr, 10);
  void* shared =
      ::mmap(nullptr, sizeof(std::atomic<std::int64_t>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(shared, MAP_FAILED);
  auto& newest_ns = *new (shared) std::atomic<std::int64_t>(0);
  std::mt19937 random(5);
  std::vector<double> lost_s;
  for (std::size_t i = 0; i < crashes; ++i) {
    const samples::Folder folder;
    ChildProcess child([&]() -> int { recordForEver(folder.file(), newest_ns); });
    ASSERT_TRUE(comesTrue("pictures and steps that are committed", [&] {
      const auto growing = Recording::open(folder.file());
      return growing && (*growing)->info().frames > 0U && (*growing)->info().committed_samples >= 500U;
    }));
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 500'000));
    ASSERT_EQ(child.kill(), SIGKILL);  // it had not ended by itself
    const auto recording = Recording::open(folder.file());
    ASSERT_TRUE(recording) << recording.error().text();
    const RecordingInfo& info = (*recording)->info();
    EXPECT_GT(info.frames, 0U);
    lost_s.push_back(toSeconds(Duration(newest_ns.load())) - toSeconds(info.header.started.time_since_epoch()) -
                     info.duration_s);
  }
  ::munmap(shared, sizeof(std::atomic<std::int64_t>));
  std::sort(lost_s.begin(), lost_s.end());
  std::printf("killed %zu times; lost: median %.0f ms, 95 %% %.0f ms, most %.0f ms\n", crashes,
              1e3 * lost_s[crashes / 2], 1e3 * lost_s[crashes * 95 / 100], 1e3 * lost_s.back());
  EXPECT_LT(lost_s[(crashes - 1) / 2], kMostLost_s);
}

}  // namespace
}  // namespace fyd::recording
