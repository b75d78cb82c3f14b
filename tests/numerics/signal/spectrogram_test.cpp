// A spectrogram reads the amplitude of a sine, keeps time, and shows a hole as a hole.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/signal/spectrogram.h"

namespace fyd::signal {
namespace {

struct Signal {
  std::vector<double> time_s;
  std::vector<float> values;
};

Signal sine(std::size_t samples, double frequency_Hz, double amplitude, double offset = 0.0) {
  Signal out;
  for (std::size_t i = 0; i < samples; ++i) {
    const double t_s = 10.0 + 0.001 * static_cast<double>(i);
    out.time_s.push_back(t_s);
    out.values.push_back(
        static_cast<float>(offset + amplitude * std::sin(2.0 * std::numbers::pi * frequency_Hz * t_s)));
  }
  return out;
}

TEST(Spectrogram, ReadsTheAmplitudeOfASineAndNothingOfItsOffset) {
  const Signal s = sine(4096, 125.0, 2.5, 9.81);  // 125 Hz is bin 64 of 512
  const Spectrogram found = spectrogram(s.time_s, s.values, 1000.0, 512);
  ASSERT_EQ(found.bins, 257U);
  ASSERT_EQ(found.segments(), 15U);
  const std::vector<double> mean = found.mean();
  EXPECT_NEAR(mean[64], 2.5, 1e-4);
  EXPECT_NEAR(mean[0], 0.0, 1e-4);
  EXPECT_NEAR(mean[100], 0.0, 1e-4);
  EXPECT_NEAR(found.resolution_Hz * 256, 500.0, 1e-9);
}

TEST(Spectrogram, ASineBetweenTwoBinsReadsAtMostFifteenPercentLow) {
  for (const double shift : {0.0, 0.25, 0.5, 0.75}) {
    const Signal s = sine(1024, (64.0 + shift) * 1000.0 / 512.0, 1.0);
    const std::vector<double> mean = spectrogram(s.time_s, s.values, 1000.0, 512).mean();
    const double peak = *std::max_element(mean.begin(), mean.end());
    EXPECT_GT(peak, 0.84) << shift;
    EXPECT_LT(peak, 1.001) << shift;
  }
}

TEST(Spectrogram, ABurstStandsInItsOwnSegmentsOnly) {
  Signal s = sine(4096, 125.0, 1.0);
  for (std::size_t i = 0; i < s.values.size(); ++i) {
    if (i < 2048) s.values[i] = 0.0F;
  }
  const Spectrogram found = spectrogram(s.time_s, s.values, 1000.0, 512);
  EXPECT_NEAR(found.segment(0)[64], 0.0, 1e-9);
  EXPECT_NEAR(found.segment(found.segments() - 1)[64], 1.0, 1e-4);
  EXPECT_NEAR(found.first_time_s, 10.2555, 1e-9);
  EXPECT_NEAR(found.step_s, 0.256, 1e-12);
}

TEST(Spectrogram, AHoleAndAValueThatIsNoneAreNotCountedAsSilence) {
  Signal s = sine(2048, 125.0, 1.0);
  s.values[1000] = std::nanf("");
  for (std::size_t i = 1536; i < s.time_s.size(); ++i) s.time_s[i] += 0.5;
  const Spectrogram found = spectrogram(s.time_s, s.values, 1000.0, 512);
  std::size_t holes = 0;
  for (std::size_t i = 0; i < found.segments(); ++i) holes += std::isnan(found.segment(i)[64]) ? 1 : 0;
  EXPECT_EQ(holes, 5U);  // two hold the NaN, one the beginning of the half second that is missing, two lie inside of it
  EXPECT_NEAR(found.mean()[64], 1.0, 1e-4);
}

TEST(Spectrogram, WhatFollowsAHoleInTimeStandsWhereItWasMeasured) {
  Signal s = sine(4096, 125.0, 0.0);
  for (std::size_t i = 2048; i < s.time_s.size(); ++i) {
    s.time_s[i] += 10.24;  // 40 steps
    s.values[i] = static_cast<float>(std::sin(2.0 * std::numbers::pi * 125.0 * s.time_s[i]));
  }
  const Spectrogram found = spectrogram(s.time_s, s.values, 1000.0, 512);
  ASSERT_EQ(found.segments(), 15U + 40U);
  for (std::size_t i = 0; i < found.segments(); ++i) {
    const double middle_s = found.first_time_s + found.step_s * static_cast<double>(i);
    const double level = found.segment(i)[64];
    if (middle_s < 12.048 - 0.256) {
      EXPECT_NEAR(level, 0.0, 1e-9) << middle_s;
    } else if (middle_s > 22.288 + 0.255) {
      EXPECT_NEAR(level, 1.0, 1e-4) << middle_s;
    } else {
      EXPECT_TRUE(std::isnan(level)) << middle_s;
    }
  }
}

TEST(Spectrogram, OddRequestsGiveNothing) {
  const Signal s = sine(100, 10.0, 1.0);
  EXPECT_EQ(spectrogram(s.time_s, s.values, 1000.0, 512).segments(), 0U);
  EXPECT_EQ(spectrogram(s.time_s, s.values, 1000.0, 4).segments(), 0U);
  EXPECT_EQ(spectrogram(s.time_s, s.values, 0.0, 64).segments(), 0U);
  EXPECT_EQ(spectrogram(s.time_s, std::span(s.values).first(50), 1000.0, 32).segments(), 0U);
  EXPECT_EQ(spectrogram({}, {}, 1000.0, 64).segments(), 0U);
}

}  // namespace
}  // namespace fyd::signal
