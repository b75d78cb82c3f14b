// Replay: bit-exact, with other parameters, closed loop; and a recording used as a device.
#include <map>

#include <opencv2/core.hpp>

#include "core/recording/writer/recording_writer.h"
#include "core/replay/recorded_camera.h"
#include "core/replay/recorded_touchpad.h"
#include "core/replay/replay.h"
#include "tests/integration/recording/recorder_replay_fixture.h"

namespace fyd::replay {
namespace {

using testing::HasSubstr;

class Replay : public recording::Recorded {
 protected:
  /// @param before_s how long the session ran before it was recorded
  std::unique_ptr<recording::Recording> record(double before_s, double seconds, double pre_trigger_s = 10.0) {
    startRecorder({.pre_trigger_s = pre_trigger_s});
    run(before_s);
    const auto begun = recorder->begin({.path = file("session.h5")});
    EXPECT_TRUE(begun) << (begun ? "" : begun.error().text());
    run(seconds);
    const auto ended = recorder->end();
    EXPECT_TRUE(ended) << (ended ? "" : ended.error().text());
    if (!another_program) {
      EXPECT_EQ(recorder->status().differences, 0U);
    }
    return open("session.h5");
  }

  bool another_program = false;  ///< the recording is as one with other ranges would have made it
};

TEST_F(Replay, IsIdenticalFromTheFirstStepOn) {
  before_step = [this](pipeline::Inputs& in) {
    if (steps == 1500) (void)in.changes.push({.index = 0, .value = 100.0});  // refused: not live
    if (steps == 2500) (void)in.commands.push({.action = pipeline::OperatorAction::stop});
    if (steps == 2600) (void)in.commands.push({.action = pipeline::OperatorAction::arm});
  };
  const auto recording = record(0.2, 6.0);
  ASSERT_TRUE(recording);
  std::uint64_t seen = 0;
  const auto result = replay::replay(*recording, {}, [&](const auto&, const auto&) { ++seen; });
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_TRUE(result->identical) << result->different << " differ, first " << result->first_difference_s << " s "
                                 << result->first_difference_field;
  EXPECT_EQ(result->samples, 6200U);
  EXPECT_EQ(seen, 6200U);
  EXPECT_FALSE(result->what_if);
  EXPECT_GT(result->speed_x, 1.0);
}

TEST_F(Replay, IsIdenticalFromTheMiddleOfASession) {
  const auto recording = record(8.0, 3.0, 2.0);
  ASSERT_TRUE(recording);
  ASSERT_GT(recording->step(0)->telemetry.step, 4000U);
  const auto result = replay::replay(*recording, {});
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_TRUE(result->identical) << result->first_difference_s << " s " << result->first_difference_field;
}

/// A robot that feels now this, now that, at several places and at none.
pipeline::RobotState toldAt(double t_s) {
  const double place = std::fmod(t_s, 3.0);
  return {.stiffness_N_per_mm = place < 0.3   ? 0.0
                                : place < 1.6 ? 0.52
                                              : 0.70,
          .position_mm = {4.0 * std::floor(place), 0.0, -2.0 - place},
          .force_N = 2.0 + std::sin(5.0 * t_s)};
}

TEST_F(Replay, IsIdenticalFromTheMiddleOfASessionWithEachCoupling) {
  for (std::size_t i = 0; i < teleop::kTouchpadCouplingNames.size(); ++i) {
    SCOPED_TRACE(teleop::kTouchpadCouplingNames[i]);
    steps = 0;
    options.parameters.step.coupling = static_cast<teleop::TouchpadCouplingChoice>(i);
    before_step = [this](pipeline::Inputs& in) {
      in.robot.state = {};
      const auto tens = steps / 10;
      in.robot.state.set(toldAt(1e-2 * static_cast<double>(tens)), in.now);
      in.robot.state.count = 1 + tens;
    };
    samples.clear();
    const auto recording = record(5.0, 4.0, 1.0);
    ASSERT_TRUE(recording);
    double withheld_mJ = 0.0;
    for (const auto& sample : samples) withheld_mJ = std::max(withheld_mJ, std::abs(sample.coupling_withheld_mJ));
    EXPECT_EQ(withheld_mJ > 0.01, i >= 2) << "tdpa and model had something to withhold";
    const auto result = replay::replay(*recording, {});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_TRUE(result->identical) << result->first_difference_s << " s " << result->first_difference_field;
    recorder.reset();
    std::filesystem::remove(file("session.h5"));
  }
}

TEST_F(Replay, LiveChangesAndATareBeforeTheStartAreInTheState) {
  pipeline::Parameters copy = options.parameters;
  const auto bound = bindParameters(copy);
  const Parameter* k_vib = findParameter(bound, "texture.k_vib");
  ASSERT_TRUE(k_vib);
  before_step = [&](pipeline::Inputs& in) {
    if (steps == 500) {
      (void)in.changes.push({.index = static_cast<std::uint16_t>(k_vib - bound.data()), .value = 2.5});
    }
  };
  const auto recording = record(5.0, 1.0, 1.0);
  ASSERT_TRUE(recording);
  EXPECT_THAT(recording->info().header.profile, HasSubstr("k_vib = 2.5"));
  const auto result = replay::replay(*recording, {});
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_TRUE(result->identical) << result->first_difference_field;
}

TEST_F(Replay, OfOtherInputsIsFoundOutWithTimeAndField) {
  const auto recording = record(0.2, 2.0);
  ASSERT_TRUE(recording);
  const auto result = replay::replay(*recording, {.settings = {"texture.k_vib=1.7"}});
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_TRUE(result->what_if);
  EXPECT_FALSE(result->identical);
  EXPECT_FALSE(result->from_rest) << "k_vib is live: the recorded state serves";
  EXPECT_GT(result->different, 100U);
  EXPECT_GE(result->first_difference_s, 0.0);
  EXPECT_FALSE(result->first_difference_field.empty());
}

TEST_F(Replay, AParameterThatIsNotLiveStartsFromRest) {
  const auto recording = record(0.2, 4.0);
  ASSERT_TRUE(recording);
  pipeline::TelemetrySample last;
  const auto result = replay::replay(*recording, {.settings = {"pipeline.bridge_maximum_age_ms=90"}},
                                     [&](const auto& sample, const auto&) { last = sample; });
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_TRUE(result->from_rest);
  EXPECT_EQ(last.state, pipeline::SafetyState::active) << "it armed where the operator had";
}

TEST_F(Replay, MoreLiveSettingsThanAStepTakesAreRefusedAndNoneIsForgotten) {
  const auto recording = record(0.2, 2.0);
  ASSERT_TRUE(recording);
  pipeline::Parameters copy = options.parameters;
  std::vector<std::string> settings;
  for (const Parameter& each : bindParameters(copy)) {  // as they are
    if (settings.size() < pipeline::kMaximumCommandsPerStep && each.kind == ParameterKind::real && each.info.live &&
        each.id != "texture.k_vib") {
      settings.push_back(fmt::format("{}={}", each.id, each.value()));
    }
  }
  ASSERT_EQ(settings.size(), pipeline::kMaximumCommandsPerStep);
  EXPECT_TRUE(replay::replay(*recording, {.settings = settings})) << "as many as a step takes";
  settings.emplace_back("texture.k_vib=1.7");
  const auto refused = replay::replay(*recording, {.settings = settings});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), HasSubstr("17 parameters change with the first step"));
  EXPECT_THAT(refused.error().text(), HasSubstr("at most 16"));

  std::vector<double> of_all;
  std::vector<double> of_two;
  const auto into = [](std::vector<double>& out) {
    return [&out](const auto& sample, const auto&) {
      out.push_back(std::isnan(sample.vibration_duty_percent) ? -1.0 : sample.vibration_duty_percent);
    };
  };
  settings.emplace_back("pipeline.bridge_maximum_age_ms=90");  // not live: the step is made with all of them
  ASSERT_TRUE(replay::replay(*recording, {.settings = settings}, into(of_all)));
  ASSERT_TRUE(replay::replay(*recording, {.settings = {settings.end() - 2, settings.end()}}, into(of_two)));
  EXPECT_EQ(of_all, of_two);
  std::vector<double> without;
  ASSERT_TRUE(replay::replay(*recording, {.settings = {settings.back()}}, into(without)));
  EXPECT_NE(of_all, without) << "k_vib counts";
}

TEST_F(Replay, WrongSettingsAreNamed) {
  const auto recording = record(0.2, 0.5);
  ASSERT_TRUE(recording);
  for (const char* setting :
       {"control.kp", "nothing.at_all=1", "control.kp=fast", "texture.k_vib=nan", "sensing.frame_half_width_mm=1e9"}) {
    const auto result = replay::replay(*recording, {.settings = {setting}});
    ASSERT_FALSE(result) << setting;
    EXPECT_THAT(result.error().text(), HasSubstr(std::string(setting).substr(0, std::string(setting).find('='))));
  }
}

TEST_F(Replay, AWhatIfBeyondTheRangeOfALiveParameterIsComputedAndMarkedAndNoCommandLeavesItsLimits) {
  const auto recording = record(0.2, 2.0);
  ASSERT_TRUE(recording);
  for (const char* setting : {"texture.k_vib=1e9", "control.kp=-1e300", "texture.full_scale_g=1e-300"}) {
    double largest_percent = 0.0;
    const auto result = replay::replay(*recording, {.settings = {setting}}, [&](const auto& sample, const auto&) {
      EXPECT_TRUE(std::isfinite(sample.vibration_duty_percent));
      EXPECT_TRUE(std::isfinite(sample.stretch_reference_deg));
      largest_percent = std::max(largest_percent, std::abs(sample.vibration_duty_percent));
    });
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(result->out_of_range.size(), 1U) << setting;
    EXPECT_LE(largest_percent, 100.0) << setting;
  }
}

TEST_F(Replay, ARobotsKeyComesToTheValueItCameToWhateverTheRangeIsToday) {
  pipeline::Parameters copy = options.parameters;
  const auto bound = bindParameters(copy);
  const auto k_vib = static_cast<std::uint16_t>(findParameter(bound, "texture.k_vib") - bound.data());
  // In the program that recorded this the range went to 15 at first; the second key is pressed at its end.
  const std::map<std::size_t, double> came_to{{600, 12.1}, {1200, 12.1}};
  another_program = true;
  before_step = [&](pipeline::Inputs& in) {
    lockstep->pipeline().takeRecordedValues();
    if (steps == 500) (void)in.changes.push({.index = k_vib, .value = 12.0});
    if (came_to.contains(steps)) (void)in.changes.push({.index = k_vib, .value = came_to.at(steps)});
  };
  as_recorded = [&](pipeline::Inputs& in) {
    if (!came_to.contains(steps)) return;
    in.changes.clear();
    (void)in.robot.commands.push(pipeline::RobotCommand::vibration_up);
  };
  const auto recording = record(0.2, 2.0);
  ASSERT_TRUE(recording);
  const auto result = replay::replay(*recording, {});
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_TRUE(result->identical) << result->first_difference_s << " s " << result->first_difference_field;
  EXPECT_THAT(result->out_of_range, testing::ElementsAre("texture.k_vib"));
}

TEST_F(Replay, ARobotsKeyIsNotFollowedWhereItsParameterIsSet) {
  before_step = [this](pipeline::Inputs& in) {
    if (steps == 1000) (void)in.robot.commands.push(pipeline::RobotCommand::vibration_up);
  };
  const auto recording = record(0.2, 2.0);
  ASSERT_TRUE(recording);
  EXPECT_TRUE(replay::replay(*recording, {})->identical);
  const auto set = replay::replay(*recording, {.settings = {"texture.k_vib=1"}});  // as it was until the key
  ASSERT_TRUE(set) << set.error().text();
  EXPECT_GT(set->different, 100U);
  EXPECT_NEAR(set->first_difference_s, 1.0, 0.02);
}

TEST_F(Replay, OnlyAnArithmeticThatIsKnownExplainsADifference) {
  const auto recording = record(0.2, 0.5);
  ASSERT_TRUE(recording);
  for (const int arithmetic : {pipeline::kArithmetic - 1, pipeline::kArithmetic + 1}) {
    SCOPED_TRACE(arithmetic);
    const std::string path = file(fmt::format("arithmetic_{}.h5", arithmetic));
    recording::RecordingHeader header = recording->info().header;
    header.arithmetic = arithmetic;
    auto writer = recording::RecordingWriter::create(path, header);
    ASSERT_TRUE(writer) << writer.error().text();
    for (std::uint64_t row = 0; row < recording->info().committed_samples; ++row) {
      auto step = recording->step(row);
      ASSERT_TRUE(step);
      if (row == 300) step->telemetry.force_N += 1e-12;  // within what is known of the older one
      ASSERT_TRUE((*writer)->append(*step));
    }
    ASSERT_TRUE((*writer)->close());
    const auto made = recording::Recording::open(path);
    ASSERT_TRUE(made) << made.error().text();
    const auto result = replay::replay(**made, {});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(result->different, 1U);
    EXPECT_FALSE(result->identical);
    EXPECT_EQ(result->explained, arithmetic < pipeline::kArithmetic);
  }
}

TEST_F(Replay, ATargetByHandIsNotFollowedWhereItIsSetAndStillTakesTheTargetFromTheRobot) {
  constexpr double kSet_N_per_mm = 0.71;
  before_step = [this](pipeline::Inputs& in) {
    if (steps == 500) (void)in.commands.push({.action = pipeline::OperatorAction::target_from_robot});
    if (steps == 1000) {
      (void)in.commands.push({.action = pipeline::OperatorAction::target_by_hand, .value = 0.55});
    }
  };
  const auto recording = record(0.2, 2.0);
  ASSERT_TRUE(recording);
  EXPECT_TRUE(replay::replay(*recording, {})->identical);
  pipeline::TelemetrySample last;
  pipeline::TelemetrySample last_recorded;
  const auto set =
      replay::replay(*recording, {.settings = {fmt::format("pipeline.hand_target_N_per_mm={}", kSet_N_per_mm)}},
                     [&](const auto& replayed, const auto& recorded) {
                       last = replayed;
                       last_recorded = recorded;
                     });
  ASSERT_TRUE(set) << set.error().text();
  EXPECT_EQ(last_recorded.target_N_per_mm, 0.55);
  EXPECT_EQ(last.target_N_per_mm, kSet_N_per_mm);
}

TEST_F(Replay, ATareLeavesAForceZeroThatIsSet) {
  constexpr double kSet_N = 0.5;
  constexpr double kNoise_N = 0.2;
  options.finger = sim::FingerPath::constant(0.0, 0.0, 0.0);
  before_step = [this](pipeline::Inputs& in) {
    if (steps == 1000) (void)in.commands.push({.action = pipeline::OperatorAction::tare});
  };
  const auto recording = record(0.2, 8.0);
  ASSERT_TRUE(recording);
  EXPECT_TRUE(replay::replay(*recording, {})->identical);
  const auto events = recording->events();
  ASSERT_TRUE(events);
  ASSERT_TRUE(
      std::ranges::any_of(*events, [](const auto& row) { return row.event.kind == pipeline::EventKind::tare_done; }));
  std::vector<double> forces_N;
  const auto set = replay::replay(*recording, {.settings = {fmt::format("sensing.force_zero_N={}", kSet_N)}},
                                  [&](const auto& replayed, const auto&) { forces_N.push_back(replayed.force_N); });
  ASSERT_TRUE(set) << set.error().text();
  EXPECT_NEAR(forces_N[990] + kSet_N, samples[990].force_N, 1e-9);
  EXPECT_NEAR(forces_N.back(), forces_N[990], kNoise_N) << "of the tare it would be about 0 from there on";
}

TEST_F(Replay, ATargetByHandThatWasRefusedIsRefusedAgainAndOneThatWasTakenIsMarked) {
  for (const double target_N_per_mm : {100.0, -1.0}) {
    steps = 0;
    another_program = target_N_per_mm < 0.0;
    before_step = [&](pipeline::Inputs& in) {
      if (another_program) lockstep->pipeline().takeRecordedValues();
      if (steps == 1000) {
        (void)in.commands.push({.action = pipeline::OperatorAction::target_by_hand, .value = target_N_per_mm});
      }
    };
    const auto recording = record(0.2, 2.0);
    ASSERT_TRUE(recording);
    const auto result = replay::replay(*recording, {});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_TRUE(result->identical) << target_N_per_mm << ": " << result->first_difference_s << " s "
                                   << result->first_difference_field;
    EXPECT_EQ(result->out_of_range.size(), target_N_per_mm < 0.0 ? 1U : 0U);
    std::filesystem::remove(file("session.h5"));
  }
}

TEST_F(Replay, AClosedLoopWithNothingChangedGivesTheRecording) {
  options.finger = sim::FingerPath::constant(0.0, 0.0, 6.0);
  before_step = [this](pipeline::Inputs& in) {  // a staircase of targets excites the cloth
    if (steps < 1000 || steps % 1500 != 0) return;
    const double targets[] = {0.62, 0.80, 0.66, 0.75};  // what 6 mm in the middle can do
    (void)in.commands.push({.action = pipeline::OperatorAction::target_by_hand, .value = targets[steps / 1500 % 4]});
  };
  const auto recording = record(0.2, 16.0);
  ASSERT_TRUE(recording);
  const auto same = replay::replay(*recording, {.closed_loop = true});
  ASSERT_TRUE(same) << same.error().text();
  EXPECT_TRUE(same->identical) << same->first_difference_s << " s " << same->first_difference_field;
  ASSERT_TRUE(same->cloth);
  EXPECT_GT(same->cloth->residual_rms_relative, 0.0);
  EXPECT_LT(same->cloth->residual_rms_relative, 0.2);

  // A far slower integral: the loop answers, so that the measured stretch itself differs.
  double apart_deg = 0.0;
  double apart_N = 0.0;
  const auto slow = replay::replay(*recording, {.settings = {"control.ki=0.01"}, .closed_loop = true},
                                   [&](const auto& replayed, const auto& recorded) {
                                     const double d =
                                         std::abs(replayed.stretch_measured_deg - recorded.stretch_measured_deg);
                                     if (std::isfinite(d)) apart_deg = std::max(apart_deg, d);
                                     const double f = std::abs(replayed.force_N - recorded.force_N);
                                     if (std::isfinite(f)) apart_N = std::max(apart_N, f);
                                   });
  ASSERT_TRUE(slow) << slow.error().text();
  EXPECT_FALSE(slow->identical);
  EXPECT_GT(apart_deg, 1.0);
  EXPECT_GT(apart_N, 0.01) << "the cloth answers";
  // With the recorded inputs the encoders say what they said, whatever the loop now asks for.
  int measured = 0;
  double asked_apart_deg = 0.0;
  const auto open_loop =
      replay::replay(*recording, {.settings = {"control.ki=0.01"}}, [&](const auto& replayed, const auto& recorded) {
        EXPECT_EQ(std::isnan(replayed.stretch_measured_deg), std::isnan(recorded.stretch_measured_deg));
        if (std::isnan(recorded.stretch_measured_deg)) return;
        ++measured;
        EXPECT_EQ(replayed.stretch_measured_deg, recorded.stretch_measured_deg);
        const double asked = std::abs(replayed.stretch_reference_deg - recorded.stretch_reference_deg);
        if (std::isfinite(asked)) asked_apart_deg = std::max(asked_apart_deg, asked);
      });
  ASSERT_TRUE(open_loop);
  EXPECT_FALSE(open_loop->cloth);
  EXPECT_GT(measured, 15'000);
  EXPECT_GT(asked_apart_deg, 1.0);
}

TEST_F(Replay, AClosedLoopIsRefusedWhenTheRecordingDoesNotIdentifyTheCloth) {
  options.finger = sim::FingerPath::constant(0.0, 0.0, 0.0);
  const auto recording = record(0.2, 3.0);
  ASSERT_TRUE(recording);
  const auto result = replay::replay(*recording, {.closed_loop = true});
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().text(), HasSubstr("does not say how the cloth answers"));
}

TEST_F(Replay, ARecordingIsATouchpad) {
  const auto recording = record(0.2, 2.0);
  ASSERT_TRUE(recording);
  auto opened = RecordedTouchpad::open(file("session.h5"), std::make_shared<PlaybackStart>());
  ASSERT_TRUE(opened) << opened.error().text();
  EXPECT_THAT((*opened)->description().text(), HasSubstr("motors are not driven"));
  const Instant start = instantAt(5000.0);
  for (int ms = 0; ms < 2150; ms += 7) {
    const Instant now = start + std::chrono::milliseconds(ms);
    const auto readings = (*opened)->exchange({.active = true}, now);
    ASSERT_TRUE(readings) << ms << ": " << readings.error().text();
    const auto row = recording->step(static_cast<std::uint64_t>(ms));
    ASSERT_TRUE(row);
    EXPECT_EQ(readings->bridge.value.value_mV_per_V, row->inputs.bridge.value.value_mV_per_V) << ms;
    EXPECT_EQ(readings->bridge.count, row->inputs.bridge.count);
    if (readings->bridge.count > 0) {
      EXPECT_EQ(now - readings->bridge.taken, row->inputs.now - row->inputs.bridge.taken);
    }
  }
  const auto after = (*opened)->exchange({}, start + std::chrono::seconds(3));
  ASSERT_FALSE(after);
  EXPECT_THAT(after.error().text(), HasSubstr("has ended"));
}

TEST_F(Replay, ARecordingIsACamera) {
  startRecorder();
  run(0.5);
  cv::Mat picture(240, 320, CV_8UC1);
  cv::randu(picture, 0, 255);
  const cv::Rect region(50, 45, 220, 150);
  for (int i = 0; i < 3; ++i) {
    recorder->offerPicture(picture, region, {}, samples.back().now - std::chrono::milliseconds(300 - 50 * i),
                           static_cast<std::uint64_t>(i) + 1);
  }
  ASSERT_TRUE(recorder->begin({.path = file("seen.h5")}));
  run(0.2);
  ASSERT_TRUE(recorder->end());
  auto camera = RecordedCamera::open(file("seen.h5"), std::make_shared<PlaybackStart>());
  ASSERT_TRUE(camera) << camera.error().text();
  Instant before{};
  for (std::uint64_t number = 1; number <= 3; ++number) {
    const auto frame = (*camera)->next();
    ASSERT_TRUE(frame) << frame.error().text();
    EXPECT_EQ(frame->number, number);
    EXPECT_EQ(cv::norm(frame->picture(region), picture(region), cv::NORM_INF), 0.0);
    if (number > 1) {
      EXPECT_EQ(frame->taken - before, std::chrono::milliseconds(50));
    }
    before = frame->taken;
  }
  const auto after = (*camera)->next();
  ASSERT_FALSE(after);
  EXPECT_THAT(after.error().text(), HasSubstr("has ended"));
  EXPECT_FALSE(RecordedCamera::open(file("nothing.h5"), std::make_shared<PlaybackStart>()));
}

}  // namespace
}  // namespace fyd::replay
