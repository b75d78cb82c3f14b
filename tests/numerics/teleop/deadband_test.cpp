#include "core/teleop/deadband.h"

#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/not_a_number.h"

namespace fyd::teleop {
namespace {

/// Column `name` of a recording of 1 kHz.
std::vector<double> column(const std::string& file_name, const std::string& name) {
  std::ifstream file(fmt::format("{}/teleop_1dof/{}", FYD_TEST_DATA, file_name));
  std::string line, cell;
  std::getline(file, line);
  std::size_t at = 0;
  std::stringstream head(line);
  for (std::size_t i = 0; std::getline(head, cell, ','); ++i) {
    if (cell == name) at = i;
  }
  std::vector<double> out;
  while (std::getline(file, line)) {
    std::stringstream row(line);
    for (std::size_t i = 0; i <= at; ++i) std::getline(row, cell, ',');
    out.push_back(std::strtod(cell.c_str(), nullptr));
  }
  EXPECT_GT(out.size(), 1000U);
  return out;
}

struct Outcome {
  double packets = 0.0;  ///< share of the samples
  double known = 0.0;    ///< share of the ticks, asked 100 ms back
  double worst = 0.0;  ///< largest |error| − 10 % of the true value's neighbourhood, where it is known; ≤ 0 is right
};

/// The truth of the bound is written here once more: |x − y| ≤ max(floor, 10 % of |y|), y what the receiver answers.
Outcome send(const std::vector<double>& x, const DeadbandChannel& channel, double loss, double jitter_ms,
             unsigned seed) {
  DeadbandChannels channels{};
  channels[0] = channel;
  DeadbandSender sender(channels);
  DeadbandReceiver receiver;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::multimap<double, DeadbandPacket> underway;
  Outcome out;
  double ticks = 0.0;
  out.worst = -1e9;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double now = 0.001 * static_cast<double>(i);
    if (const auto packet = sender.step(now, {x[i]})) {
      out.packets += 1.0;
      if (uniform(random) >= loss) underway.emplace(now + 0.02 + 0.001 * jitter_ms * uniform(random), *packet);
      if (uniform(random) < 0.1) underway.emplace(now + 0.5, *packet);  // once more, long after
    }
    while (!underway.empty() && underway.begin()->first <= now) {
      receiver.receive(underway.begin()->second);
      underway.erase(underway.begin());
    }
    if (i < 300) continue;
    const auto answer = receiver.at(0.001 * static_cast<double>(i - 150));
    ticks += 1.0;
    if (!answer.known) continue;
    out.known += 1.0;
    const double error = std::abs(x[i - 150] - answer.value[0]);
    out.worst = std::max(out.worst, error - std::max(channel.floor, channel.fraction * std::abs(answer.value[0])));
  }
  out.packets /= static_cast<double>(x.size());
  out.known /= ticks;
  return out;
}

TEST(Deadband, ARefreshShorterThanTheFirstRepeatIsKept) {
  DeadbandSender sender({}, 0.0055);
  double last_s = 0.0, longest_s = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double now_s = 0.001 * i;
    if (!sender.step(now_s, {1.0})) continue;
    longest_s = std::max(longest_s, now_s - last_s);
    last_s = now_s;
  }
  EXPECT_NEAR(longest_s, 0.006, 1e-9);
  EXPECT_GT(last_s, 0.19);
}

TEST(Deadband, AtTenPercentNineOfTenPacketsOfRecordedForcesAreNotSentAndTheBandHolds) {
  for (const char* file : {"c_free_motion.csv", "d_foam.csv"}) {
    for (const char* name : {"human_force_N", "environment_force_N"}) {
      const auto force = column(file, name);
      for (const double loss : {0.0, 0.2}) {
        for (unsigned seed = 1; seed <= 5; ++seed) {
          const Outcome out = send(force, {.fraction = 0.10, .floor = 0.1}, loss, 30.0, seed);
          EXPECT_LE(out.packets, 0.10) << file << ' ' << name;
          EXPECT_LE(out.worst, 1e-9) << file << ' ' << name << ", loss " << loss;
          EXPECT_GE(out.known, loss > 0.0 ? 0.90 : 0.999) << file << ' ' << name << ", loss " << loss;
        }
      }
    }
  }
}

TEST(Deadband, WhereHalfIsLostTheBandStillHoldsOrItIsSaid) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<double> x;
  for (int i = 0; i < 20'000; ++i) {
    const double t = 0.001 * i;
    x.push_back(5.0 * std::sin(9.0 * t) * std::sin(2.0 * t) + (i / 3000 % 2 == 0 ? 0.0 : 0.3 * noise(random)));
  }
  for (const double loss : {0.2, 0.5, 0.9, 1.0}) {
    const Outcome out = send(x, {.fraction = 0.10, .floor = 0.02}, loss, 80.0, 3);
    EXPECT_LE(out.worst, 1e-9) << loss;
    if (loss == 0.2) {
      EXPECT_GT(out.known, 0.9);
    }
    if (loss == 1.0) {
      EXPECT_EQ(out.known, 0.0);
    }
  }
}

TEST(Deadband, APlaceThatMovesIsKnownWithinTheBandAndTheCurveBetweenSamplesIsNearer) {
  // A hand of 30 mm and 1 Hz with a faster tremble: its speed is the derivative, written here by hand.
  const auto place = [](double t) { return 30.0 * std::sin(6.0 * t) + 0.4 * std::sin(50.0 * t); };
  const auto speed = [](double t) { return 180.0 * std::cos(6.0 * t) + 20.0 * std::cos(50.0 * t); };
  const DeadbandChannel channel{.fraction = 0.10, .floor = 0.1, .moves = true};
  for (const double loss : {0.0, 0.2, 0.5}) {
    DeadbandChannels channels{};
    channels[0] = channel;
    DeadbandSender sender(channels, 0.05, 3);
    DeadbandReceiver receiver;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::multimap<double, DeadbandPacket> underway;
    double packets = 0.0, known = 0.0, ticks = 0.0, straight = 0.0, curved = 0.0;
    for (int i = 0; i < 20'000; ++i) {
      const double now = 0.001 * i;
      if (const auto packet = sender.step(now, {place(now)}, {speed(now)})) {
        packets += 1.0;
        EXPECT_LE(packet->size(), 3U);
        if (uniform(random) >= loss) underway.emplace(now + 0.02 + 0.04 * uniform(random), *packet);
      }
      for (; !underway.empty() && underway.begin()->first <= now; underway.erase(underway.begin())) {
        receiver.receive(underway.begin()->second);
      }
      if (i < 500) continue;
      const double asked = 0.001 * (i - 250);  // a moment at which the sender looked
      const auto answer = receiver.at(asked);
      ticks += 1.0;
      if (!answer.known) continue;
      known += 1.0;
      const double error = std::abs(place(asked) - answer.value[0]);
      EXPECT_LE(error, std::max(0.1, 0.10 * 0.05 * std::abs(answer.slope[0])) + 1e-9) << "at " << asked;
      const auto curve = receiver.place(asked, 0, channel);
      if (!curve) continue;
      straight += error * error;
      curved += (place(asked) - *curve) * (place(asked) - *curve);
    }
    EXPECT_LT(packets, 0.10 * 20'000) << loss;
    EXPECT_GT(known / ticks, loss > 0.3 ? 0.75 : loss > 0.0 ? 0.97 : 0.999) << loss;
    EXPECT_LT(curved, 0.05 * straight) << loss;
  }
}

TEST(Deadband, WhatTheMessageMadeOfASampleIsWhatTheBandIsAbout) {
  DeadbandChannels channels{};
  channels[0] = {.fraction = 0.0, .floor = 1.0};
  DeadbandSender sender(channels);
  EXPECT_TRUE(sender.step(0.0, {10.4}));
  sender.told({10.0}, {});  // whole numbers go over this wire
  EXPECT_FALSE(sender.step(0.001, {10.9}));
  EXPECT_TRUE(sender.step(0.002, {11.1}));
  sender.told({kNaN}, {});  // passed over
  EXPECT_FALSE(sender.step(0.003, {11.1}));
  EXPECT_TRUE(sender.step(0.004, {11.1}, {}, true));
}

TEST(Deadband, AConstantIsRefreshedAndASilenceIsNotTakenForOne) {
  DeadbandChannels channels{};
  DeadbandSender sender(channels);
  DeadbandReceiver receiver;
  std::vector<double> sent_at;
  for (int i = 0; i < 2000; ++i) {
    const auto packet = sender.step(0.001 * i, {3.0, kNaN, -1.0});
    if (!packet) continue;
    sent_at.push_back(0.001 * i);
    if (i < 1000) receiver.receive(*packet);
  }
  for (std::size_t i = 1; i < sent_at.size(); ++i) EXPECT_LE(sent_at[i] - sent_at[i - 1], 0.1011);
  EXPECT_LE(sent_at.size(), 26U);
  EXPECT_TRUE(receiver.at(0.5).known);
  EXPECT_EQ(receiver.at(0.5).value[0], 3.0);
  EXPECT_EQ(receiver.at(0.5).value[1], 0.0);
  EXPECT_EQ(receiver.at(1.9).value[2], -1.0);
  EXPECT_FALSE(receiver.at(1.9).known);  // nothing has been heard of that time
  EXPECT_FALSE(receiver.at(-1.0).known);
}

TEST(Deadband, WhatIsBeyondChannelsOrHistoryIsNotThere) {
  DeadbandChannels channels{};
  channels[0].moves = true;
  for (const std::size_t history : {std::size_t{0}, std::size_t{1'000'000}}) {
    DeadbandSender sender(channels, DeadbandSender::kRefresh_s, history);
    DeadbandReceiver receiver;
    for (int i = 0; i < 300; ++i) {
      if (const auto packet = sender.step(0.001 * i, {0.01 * i}, {10.0})) receiver.receive(*packet);
    }
    EXPECT_TRUE(receiver.at(0.15).known) << history;
    EXPECT_TRUE(receiver.place(0.15, 0, channels[0])) << history;
    for (const std::size_t channel : {kMostDeadbandChannels, std::numeric_limits<std::size_t>::max()}) {
      EXPECT_FALSE(receiver.place(0.15, channel, channels[0]));
    }
  }
}

TEST(Deadband, HostilePacketsChangeNothing) {
  DeadbandReceiver receiver;
  const auto packet = [](std::uint32_t number, double date_s, double value) {
    DeadbandPacket out;
    EXPECT_TRUE(out.push({.number = number, .date_s = date_s, .value = {value}, .slope = {}}));
    return out;
  };
  receiver.receive(packet(1, 1.0, 5.0));
  for (const auto& hostile :
       {packet(2, kNaN, 7.0), packet(2, 1.5, kNaN), packet(0, 1.5, 7.0), packet(4'000'000'000U, 1.5, 7.0)}) {
    receiver.receive(hostile);
    EXPECT_EQ(receiver.at(2.0).value[0], 5.0);
    EXPECT_FALSE(receiver.at(2.0).known);
  }
  receiver.receive(packet(3, 1.2, 9.0));  // 2 is missing
  EXPECT_FALSE(receiver.at(1.1).known);
  EXPECT_TRUE(receiver.at(1.2).known);
  receiver.receive(packet(2, 1.1, 8.0));  // overtaken
  EXPECT_TRUE(receiver.at(1.15).known);
  EXPECT_EQ(receiver.at(1.15).value[0], 8.0);
}

}  // namespace
}  // namespace fyd::teleop
