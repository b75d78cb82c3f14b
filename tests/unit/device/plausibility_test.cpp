// Detection of implausible readings and pictures.
#include "core/device/touchpad/plausibility.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/device/camera/frozen_picture.h"
#include "core/device/touchpad/frozen_readings.h"

namespace fyd::device {
namespace {

using testing::HasSubstr;

/// Three distance sensors every 16 ms and two encoders, as the station's thread sees them.
struct Source {
  explicit Source(double stuck_s = 1.0) : watch(DeviceParameters{.stuck_sensor_s = stuck_s}) {}
  TouchpadReadings step(bool active = true) {
    now += std::chrono::milliseconds(16);
    sensing::IrCounts counts;
    for (std::size_t i = 0; i < 3; ++i) {
      if (static_cast<int>(i) != held) code[i] = static_cast<std::uint16_t>(2000 + random() % 30);
      static_cast<void>(counts.push(code[i]));
    }
    readings.ir.set(counts, now);
    readings.motors.set({.encoder_counts = encoder}, now);
    return watch.check(readings, {.reference_ticks = reference, .active = active}, now);
  }
  TouchpadReadings run(double seconds, bool active = true) {
    TouchpadReadings out;
    for (const Instant end = now + fromSeconds(seconds); now < end;) out = step(active);
    return out;
  }
  Plausibility watch;
  TouchpadReadings readings;
  std::array<std::uint16_t, 3> code{};
  std::array<std::uint16_t, 2> encoder = {10, 4000};
  std::array<std::int16_t, 2> reference{};
  int held = -1;
  Instant now = instantAt(100);
  std::mt19937 random{3};
};

TEST(Plausibility, HealthyReadingsPassUnchanged) {
  Source source;
  for (int i = 0; i < 2000; ++i) {
    source.encoder[0] = static_cast<std::uint16_t>((source.encoder[0] + 20) % 4096);  // 110°/s, round and round
    const TouchpadReadings out = source.step();
    ASSERT_EQ(out.ir.value[0], source.code[0]);
    ASSERT_EQ(out.motors.value.encoder_counts[0], source.encoder[0]);
    ASSERT_EQ(out.motors.taken, source.now);
    ASSERT_EQ(source.watch.complaint().text(), "");
  }
}

TEST(Plausibility, AStuckSensorIsReportedUntilItMoves) {
  Source source;
  source.run(2.0);
  source.held = 1;
  source.run(0.9);
  EXPECT_EQ(source.watch.complaint().text(), "");
  const TouchpadReadings out = source.run(0.2);
  EXPECT_THAT(source.watch.complaint().text(), HasSubstr("IR sensor 2 is stuck at code"));
  EXPECT_EQ(out.ir.value[1], source.code[1]) << "the recording shows what the sensor said";
  source.held = -1;
  source.run(0.1);
  EXPECT_EQ(source.watch.complaint().text(), "");
}

TEST(Plausibility, WhereNothingMovesNothingIsStuck) {
  Source source;
  source.run(1.0);
  const auto codes = source.code;
  sensing::IrCounts still;
  for (const auto code : codes) static_cast<void>(still.push(code));
  for (int i = 0; i < 500; ++i) {
    source.now += std::chrono::milliseconds(16);
    source.readings.ir.set(still, source.now);
    ASSERT_EQ(source.watch.check(source.readings, {.active = true}, source.now).ir.value[0], codes[0]);
  }
  EXPECT_EQ(source.watch.complaint().text(), "");
}

TEST(Plausibility, ZeroSecondsSwitchTheWatchOff) {
  Source source(0.0);
  source.held = 0;
  source.run(5.0);
  EXPECT_EQ(source.watch.complaint().text(), "");
}

TEST(Plausibility, AnEncoderThatJumpsIsWithheldUntilTheOperatorStops) {
  Source source;
  source.run(0.5);
  const Instant last = source.now;
  source.encoder[0] += 512;
  TouchpadReadings out = source.run(3.0);
  EXPECT_EQ(out.motors.taken, last) << "ages, so that the step holds";
  EXPECT_EQ(out.motors.value.encoder_counts[0], 10);
  EXPECT_THAT(source.watch.complaint().text(), HasSubstr("encoder 1 jumped by 45° in 16 ms"));
  source.encoder[0] -= 512;
  EXPECT_EQ(source.run(1.0).motors.taken, last) << "its return does not make it credible";
  out = source.run(0.1, false);
  EXPECT_EQ(out.motors.taken, source.now);
  EXPECT_EQ(source.watch.complaint().text(), "");
  EXPECT_THAT(source.watch.whyWithheld().text(), HasSubstr("encoder 1 jumped")) << "for as long as nothing is armed";
  source.step();
  EXPECT_EQ(source.watch.whyWithheld().text(), "");
}

TEST(Plausibility, AJumpWithTheMotorsOffIsShownForASecond) {
  Source source;
  source.run(0.5, false);
  source.encoder[1] = 1000;
  source.run(0.5, false);
  EXPECT_THAT(source.watch.complaint().text(), HasSubstr("encoder 2"));
  EXPECT_EQ(source.run(0.7, false).motors.value.encoder_counts[1], 1000);
}

TEST(Plausibility, AfterASilenceThereIsNothingToCompareWith) {
  Source source;
  source.run(0.5);
  source.now += std::chrono::seconds(1);
  source.encoder[0] = 2000;
  source.step();
  EXPECT_EQ(source.watch.complaint().text(), "");
}

std::int16_t ticks(double degrees) { return static_cast<std::int16_t>(degrees * 4200.0 / 90.0); }

TEST(Plausibility, AnEncoderThatDoesNotFollowItsMotorIsWithheldUntilTheOperatorStops) {
  Source source;
  source.run(0.5);
  source.reference = {ticks(9.0), ticks(-9.0)};
  source.run(5.0);
  EXPECT_EQ(source.watch.complaint().text(), "") << "friction or a finger may hold a motor back so far";
  source.reference[1] = ticks(-12.0);
  source.run(0.9);
  EXPECT_EQ(source.watch.complaint().text(), "") << "a second to begin with";
  const TouchpadReadings last = source.step();
  const TouchpadReadings out = source.run(2.0);
  EXPECT_LE(out.motors.taken - last.motors.taken, std::chrono::milliseconds(200));
  EXPECT_THAT(source.watch.complaint().text(),
              HasSubstr("encoder 2 stands still although its motor was sent 12° further"));
  source.encoder[1] = 3990;
  EXPECT_EQ(source.run(1.0).motors.taken, out.motors.taken) << "its return does not make it credible";
  EXPECT_EQ(source.run(0.1, false).motors.taken, source.now);
  EXPECT_EQ(source.watch.complaint().text(), "");
}

TEST(Plausibility, AnEncoderMayStandStillWhileItsMotorIsOffOrNotSentElsewhere) {
  Source source;
  source.reference = {ticks(20.0), ticks(-20.0)};
  source.run(5.0);
  EXPECT_EQ(source.watch.complaint().text(), "") << "it stands where it was when the motors went on";
  source.reference = {ticks(80.0), ticks(-80.0)};
  source.run(5.0, false);
  EXPECT_EQ(source.watch.complaint().text(), "");
}

TEST(Plausibility, AnEncoderThatFollowsSlowlyIsBelieved) {
  Source source;
  source.run(0.1);
  source.reference = {ticks(90.0), ticks(-90.0)};
  for (int i = 0; i < 20; ++i) {  // a count every 0.9 s
    source.run(0.9);
    ++source.encoder[0];
    --source.encoder[1];
    source.step();
    ASSERT_EQ(source.watch.complaint().text(), "");
  }
}

/// The same readings again and again, each with a new count, or with noise.
struct Sampling {
  explicit Sampling(double frozen_ms = 500.0) : watch(DeviceParameters{.frozen_reading_ms = frozen_ms}) {}
  TouchpadReadings run(double seconds) {
    TouchpadReadings out;
    for (const Instant end = now + fromSeconds(seconds); now < end;) {
      now += std::chrono::milliseconds(8);
      if (ir_noise != 0) codes[static_cast<std::size_t>(now.time_since_epoch().count() % 3)] ^= ir_noise;
      sensing::IrCounts counts;
      for (const std::uint16_t code : codes) static_cast<void>(counts.push(code));
      readings.ir.set(counts, now);
      readings.bridge.set({.value_mV_per_V = bridge += bridge_noise}, now);
      readings.motors.set({}, now);
      out = watch.check(readings);
    }
    return out;
  }
  FrozenReadings watch;
  TouchpadReadings readings;
  std::array<std::uint16_t, 3> codes = {1700, 1650, 1720};
  std::uint16_t ir_noise = 1;
  double bridge = 0.25;
  double bridge_noise = 1e-9;
  Instant now = instantAt(100);
};

TEST(FrozenReadings, SensorsThatRepeatThemselvesGrowOldThoughTheirCountGoesOn) {
  Sampling source;
  EXPECT_EQ(source.run(2.0).ir.taken, source.now);
  source.ir_noise = 0;
  TouchpadReadings out = source.run(0.4);
  EXPECT_EQ(out.ir.taken, source.now) << "chance may repeat a reading";
  EXPECT_EQ(source.watch.complaint().text(), "");
  out = source.run(1.0);
  EXPECT_GT(source.now - out.ir.taken, std::chrono::milliseconds(800));
  EXPECT_EQ(out.bridge.taken, source.now) << "the others go on";
  EXPECT_EQ(out.motors.taken, source.now);
  EXPECT_THAT(source.watch.complaint().text(), HasSubstr("the distance sensors repeat the codes"));
  source.ir_noise = 1;
  EXPECT_EQ(source.run(0.1).ir.taken, source.now);
  EXPECT_EQ(source.watch.complaint().text(), "");
}

TEST(FrozenReadings, SoDoesALoadCell) {
  Sampling source;
  source.run(1.0);
  source.bridge_noise = 0.0;
  const TouchpadReadings out = source.run(1.0);
  EXPECT_GT(source.now - out.bridge.taken, std::chrono::milliseconds(400));
  EXPECT_EQ(out.ir.taken, source.now);
  EXPECT_THAT(source.watch.complaint().text(), HasSubstr("the load cell repeats 0.25"));
}

TEST(FrozenReadings, AtTheEndsOfAConverterThereIsNoNoiseAndTheStepCallsItInvalid) {
  Sampling source;
  source.ir_noise = 0;
  source.codes = {4095, 0, 4095};
  source.bridge_noise = 0.0;
  source.bridge = -7.77;
  const TouchpadReadings out = source.run(3.0);
  EXPECT_EQ(out.ir.taken, source.now);
  EXPECT_EQ(out.bridge.taken, source.now);
  EXPECT_EQ(source.watch.complaint().text(), "");
}

TEST(FrozenReadings, ZeroMillisecondsSwitchTheWatchOff) {
  Sampling source(0.0);
  source.ir_noise = 0;
  source.bridge_noise = 0.0;
  EXPECT_EQ(source.run(3.0).ir.taken, source.now);
  EXPECT_EQ(source.watch.complaint().text(), "");
}

cv::Mat noisy(int seed) {
  cv::Mat picture(240, 320, CV_8UC1);
  cv::RNG random(static_cast<std::uint64_t>(seed));
  random.fill(picture, cv::RNG::NORMAL, 200, 2);
  return picture;
}

TEST(FrozenPicture, EqualPicturesAreNoNewsAndFrozenAfterTheLimit) {
  FrozenPicture watch(std::chrono::milliseconds(500));
  Instant now = instantAt(1);
  const auto next = [&](const cv::Mat& picture) { return watch.isNews(picture, now += std::chrono::milliseconds(33)); };
  for (int i = 0; i < 30; ++i) EXPECT_TRUE(next(noisy(i)));
  const cv::Mat same = noisy(29);
  for (int i = 0; i < 15; ++i) EXPECT_FALSE(next(same.clone()));
  EXPECT_FALSE(watch.frozen()) << "495 ms";
  EXPECT_FALSE(next(same));
  EXPECT_TRUE(watch.frozen());
  cv::Mat other = same.clone();
  other.at<std::uint8_t>(239, 319) ^= 1U;
  EXPECT_TRUE(next(other)) << "one bit in the last pixel";
  EXPECT_FALSE(watch.frozen());
}

TEST(FrozenPicture, APictureOfOneGreyIsTheDetectorsAffair) {
  FrozenPicture watch(std::chrono::milliseconds(500));
  for (int i = 0; i < 60; ++i) {
    EXPECT_TRUE(watch.isNews(cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(0)), instantAt(i / 30.0)));
  }
  EXPECT_FALSE(watch.frozen());
}

TEST(FrozenPicture, AnotherSizeIsNewsAndZeroSwitchesItOff) {
  FrozenPicture watch(std::chrono::milliseconds(500));
  EXPECT_TRUE(watch.isNews(noisy(1), instantAt(1)));
  EXPECT_TRUE(watch.isNews(noisy(1).rowRange(0, 100), instantAt(2)));
  FrozenPicture off(Duration::zero());
  for (int i = 0; i < 60; ++i) EXPECT_TRUE(off.isNews(noisy(1), instantAt(i)));
}

}  // namespace
}  // namespace fyd::device
