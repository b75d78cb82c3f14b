// A simulated session in virtual time, recorded into a temporary file.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include "core/base/profile_text.h"
#include "core/recording/file/recording_disk.h"
#include "core/recording/reader/recording.h"
#include "core/recording/writer/recorder.h"
#include "core/sim/touchpad/lockstep.h"
#include "tests/wait.h"

namespace fyd::recording {

class Recorded : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder = std::filesystem::temp_directory_path() /
             fmt::format("fyd-{}-{}-{}", test->test_suite_name(), test->name(), ::getpid());
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  void TearDown() override {
    recorder.reset();
    std::filesystem::remove_all(folder);
  }

  [[nodiscard]] std::string file(const std::string& name) const { return (folder / name).string(); }

  void startRecorder(RecorderOptions chosen = {}) {
    recorder =
        std::make_unique<Recorder>(chosen, options.parameters, options.local,
                                   StationDescription{.touchpad = "simulated", .camera = "none", .robot = "none"},
                                   StationSource{.profile =
                                                     [](const pipeline::Parameters& step) {
                                                       pipeline::Parameters copy = step;
                                                       return formatProfile(bindParameters(copy));
                                                     },
                                                 .link = {}});
    pushed = 0;
    if (disk) recorder->writeThrough(disk);
    recorder->start();
    lockstep = std::make_unique<sim::Lockstep>(options);
    lockstep->spoil = [this](pipeline::Inputs& in) {
      const double phase = 0.7 * static_cast<double>(steps++);
      (void)in.robot.accelerations.push({.taken = in.now, .acceleration_g = {std::sin(phase), std::cos(phase), 0.2}});
      if (steps == 300) (void)in.commands.push({.action = pipeline::OperatorAction::arm});
      if (before_step) before_step(in);
      inputs = in;
    };
  }

  /// Waits for the recorder's thread, so that the ring never fills on a slow machine or disk.
  void run(double seconds) {
    lockstep->run(seconds, [&](const pipeline::Outputs& outputs) {
      if (drop && drop(outputs.telemetry.step)) return;
      if (as_recorded) as_recorded(inputs);
      recorder->push({.inputs = inputs, .outputs = outputs});
      samples.push_back(outputs.telemetry);
      if (++pushed % 1000 == 0) letRecorderFollow();
    });
    letRecorderFollow();
  }
  void letRecorderFollow() const {
    ASSERT_TRUE(comesTrue("the recorder to take its steps", [this] { return recorder->status().taken >= pushed; }));
  }

  [[nodiscard]] std::unique_ptr<Recording> open(const std::string& name) const {
    auto opened = Recording::open(file(name));
    EXPECT_TRUE(opened) << (opened ? "" : opened.error().text());
    return opened ? std::move(*opened) : nullptr;
  }

  static sim::LockstepOptions usual() {
    sim::LockstepOptions out;
    out.finger = sim::FingerPath::demonstration();
    out.draw_pictures = false;
    return out;
  }

  std::filesystem::path folder;
  sim::LockstepOptions options = usual();
  std::shared_ptr<DiskCalls> disk;
  std::unique_ptr<Recorder> recorder;
  std::unique_ptr<sim::Lockstep> lockstep;
  pipeline::Inputs inputs;
  std::size_t steps = 0;
  std::uint64_t pushed = 0;
  std::function<void(pipeline::Inputs&)> before_step;
  std::function<void(pipeline::Inputs&)> as_recorded;  ///< changes what is recorded of a step
  std::function<bool(std::uint64_t)> drop;
  std::vector<pipeline::TelemetrySample> samples;
};

}  // namespace fyd::recording
