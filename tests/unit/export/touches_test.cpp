// Touches found in synthetic telemetry: bounds, interruptions, peaks, settling.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/export/touch_gesture.h"
#include "core/export/touches.h"

#include "tests/unit/recording/fake_recording.h"

namespace fyd::exports {
namespace {

using pipeline::TelemetrySample;

/// One row each millisecond; `fill` says what it holds.
template <class Fill>
recording::FakeRecording everyMillisecond(std::uint64_t rows, Fill fill) {
  return recording::FakeRecording(rows, [fill](std::uint64_t row) {
    TelemetrySample sample = recording::FakeRecording::sampleAt(0.001 * static_cast<double>(row), row + 1);
    fill(static_cast<int>(row), sample);
    return sample;
  });
}

std::vector<Touch> touchesOf(const recording::Recording& recording) {
  auto touches = findTouches(recording);
  EXPECT_TRUE(touches) << touches.error().text();
  return touches.value_or(std::vector<Touch>{});
}

TEST(Touches, NoneInAnEmptyRecordingOrWithoutContact) {
  EXPECT_TRUE(touchesOf(everyMillisecond(0, [](int, TelemetrySample&) {})).empty());
  EXPECT_TRUE(touchesOf(everyMillisecond(500, [](int, TelemetrySample& s) { s.force_N = 3.0; })).empty());
}

TEST(Touches, BoundsAreTheFirstAndLastRowInContactAlsoAtTheEnds) {
  const auto touches = touchesOf(everyMillisecond(
      1000, [](int row, TelemetrySample& s) { s.contact = row <= 200 || (row >= 400 && row < 500) || row >= 900; }));
  ASSERT_EQ(touches.size(), 3U);
  EXPECT_NEAR(touches[0].start_s, 0.0, 1e-9);
  EXPECT_NEAR(touches[0].end_s, 0.200, 1e-9);
  EXPECT_NEAR(touches[1].start_s, 0.400, 1e-9);
  EXPECT_NEAR(touches[1].end_s, 0.499, 1e-9);
  EXPECT_NEAR(touches[2].start_s, 0.900, 1e-9);
  EXPECT_NEAR(touches[2].end_s, 0.999, 1e-9);
}

TEST(Touches, ABreakShorterThanAHundredMillisecondsBelongsToTheTouch) {
  // Last contact at 200 ms; again at 299 (99 ms later) or at 300 (100 ms later).
  for (const int again : {299, 300}) {
    const auto touches = touchesOf(everyMillisecond(600, [again](int row, TelemetrySample& s) {
      s.contact = row <= 200 || row >= again;
      s.force_N = s.contact ? 1.0 : 50.0;  // what happens in the break is no part of the peak
    }));
    EXPECT_EQ(touches.size(), again == 299 ? 1U : 2U);
    EXPECT_DOUBLE_EQ(touches[0].peak_force_N, 1.0);
  }
}

TEST(Touches, LostRowsAreABreak) {
  for (const double lost_s : {0.05, 0.5}) {
    const recording::FakeRecording recording(400, [lost_s](std::uint64_t row) {
      const double time_s = 0.001 * static_cast<double>(row) + (row < 200 ? 0.0 : lost_s);
      TelemetrySample sample = recording::FakeRecording::sampleAt(time_s, row + 1);
      sample.contact = true;
      return sample;
    });
    EXPECT_EQ(touchesOf(recording).size(), lost_s < 0.1 ? 1U : 2U);
  }
}

TEST(Touches, PeaksTargetAndVibrationPassOverNaN) {
  const auto touches = touchesOf(everyMillisecond(300, [](int row, TelemetrySample& s) {
    s.contact = row >= 100;
    s.force_N = row % 2 == 0 ? pipeline::kNone : -1.0 - 0.01 * row;  // also when all are negative
    s.indentation_mm = row == 150 ? 7.5 : (row == 160 ? pipeline::kNone : 2.0);
    s.reachable_target_N_per_mm = row < 299 ? 0.5 : pipeline::kNone;
    s.vibration_duty_percent = row % 2 == 0 ? 30.0 : -40.0;
  }));
  ASSERT_EQ(touches.size(), 1U);
  EXPECT_DOUBLE_EQ(touches[0].peak_force_N, -2.01);
  EXPECT_DOUBLE_EQ(touches[0].peak_indentation_mm, 7.5);
  EXPECT_DOUBLE_EQ(touches[0].target_N_per_mm, 0.5);
  EXPECT_NEAR(touches[0].vibration_rms_percent, std::sqrt((900.0 + 1600.0) / 2.0), 1e-9);
}

TEST(Touches, NothingMeasuredStaysNaN) {
  const auto touches = touchesOf(everyMillisecond(300, [](int, TelemetrySample& s) {
    s.contact = true;
    s.stiffness_N_per_mm = 0.5;  // held from before, not observable
    s.reachable_target_N_per_mm = 0.5;
  }));
  ASSERT_EQ(touches.size(), 1U);
  EXPECT_TRUE(std::isnan(touches[0].peak_force_N));
  EXPECT_TRUE(std::isnan(touches[0].peak_indentation_mm));
  EXPECT_TRUE(std::isnan(touches[0].stiffness_N_per_mm));
  EXPECT_TRUE(std::isnan(touches[0].settling_s));
}

TEST(Touches, SettlesWhereItStaysWithinFivePercentOfTheLastTarget) {
  const auto touches = touchesOf(everyMillisecond(1000, [](int row, TelemetrySample& s) {
    s.contact = row >= 100;
    s.reachable_target_N_per_mm = row < 150 ? 2.0 : 1.0;
    s.stiffness_observable = row % 3 != 0;
    // Within the band for a moment at 300, out again, then to stay from 500 on.
    const bool inside = (row >= 300 && row < 320) || row >= 500;
    s.stiffness_N_per_mm = s.stiffness_observable ? (inside ? 1.04 : 0.7) : 99.0;
  }));
  ASSERT_EQ(touches.size(), 1U);
  EXPECT_DOUBLE_EQ(touches[0].target_N_per_mm, 1.0);
  EXPECT_NEAR(touches[0].settling_s, 0.400, 1e-9);
  EXPECT_DOUBLE_EQ(touches[0].stiffness_N_per_mm, 1.04);
}

TEST(Touches, OneThatNeverSettlesTellsTheMedianOfItsSecondHalf) {
  const auto touches = touchesOf(everyMillisecond(1001, [](int row, TelemetrySample& s) {
    s.contact = true;
    s.reachable_target_N_per_mm = 1.0;
    s.stiffness_observable = true;
    s.stiffness_N_per_mm = row < 500 ? 0.1 : (row % 2 == 0 ? 0.79 : 0.81);
  }));
  ASSERT_EQ(touches.size(), 1U);
  EXPECT_TRUE(std::isnan(touches[0].settling_s));
  EXPECT_NEAR(touches[0].stiffness_N_per_mm, 0.79, 1e-9);  // 251 of the 501 rows
}

TEST(Touches, TimeGoingBackNeitherHangsNorShortensATouch) {
  const recording::FakeRecording recording(300, [](std::uint64_t row) {
    TelemetrySample sample =
        recording::FakeRecording::sampleAt(row < 200 ? 0.001 * static_cast<double>(row) : 0.05, row + 1);
    sample.contact = true;
    return sample;
  });
  const auto touches = touchesOf(recording);
  ASSERT_EQ(touches.size(), 1U);
  EXPECT_NEAR(touches[0].end_s, 0.199, 1e-9);
}

TEST(Touches, ReadsInBlocksAndHandsOnAnError) {
  recording::FakeRecording recording =
      everyMillisecond(12'345, [](int row, TelemetrySample& s) { s.contact = row > 10; });
  EXPECT_EQ(touchesOf(recording).size(), 1U);
  EXPECT_LE(recording.largest_read_, 1000U);
  recording.failure_ = "block 3 is damaged";
  const auto touches = findTouches(recording);
  ASSERT_FALSE(touches);
  EXPECT_THAT(touches.error().text(), testing::HasSubstr("block 3"));
}

TEST(Touches, ACardsNameIsOfTheFilesNameWhatACardCanHold) {
  EXPECT_EQ(touchName("/data/foam.h5", 3), "foam.h5, touch 3");
  EXPECT_EQ(touchName("/data/a\nb\xFF.h5", 1), "ab.h5, touch 1");
  const std::string shortened = touchName(fmt::format("{:x<250}.h5", ""), 12);
  EXPECT_EQ(shortened, fmt::format("{:x<187}…, touch 12", "")) << "200 bytes";
  EXPECT_TRUE(sim::isGestureName(shortened));
}

}  // namespace
}  // namespace fyd::exports
