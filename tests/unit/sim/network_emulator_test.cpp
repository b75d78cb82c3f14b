// A path's delay, loss, reordering and line rate against shares and times worked out by hand.
#include "core/sim/network/network_emulator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include <unistd.h>

namespace fyd::sim {
namespace {

double outAfter_ms(const Passage& passage, double at_s) { return toMilliseconds(passage.out[0] - instantAt(at_s)); }

TEST(NetworkEmulator, PassesAtOnceWhenNothingIsAskedFor) {
  NetworkEmulator path({});
  const Passage passage = path.pass(1000, instantAt(1.0));
  ASSERT_EQ(passage.out.size(), 1U);
  EXPECT_EQ(passage.out[0], instantAt(1.0));
}

TEST(NetworkEmulator, DelayAndJitterHaveTheMeanAndSpreadAskedFor) {
  NetworkEmulator path({.delay_ms = 30.0, .jitter_ms = 5.0});
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kCount = 20'000;
  for (int i = 0; i < kCount; ++i) {
    const double ms = outAfter_ms(path.pass(62, instantAt(0.1 * i)), 0.1 * i);  // far apart: order holds nothing up
    EXPECT_GE(ms, 15.0 - 1e-6);
    EXPECT_LE(ms, 45.0 + 1e-6);
    sum += ms;
    squares += ms * ms;
  }
  const double mean = sum / kCount;
  EXPECT_NEAR(mean, 30.0, 0.15);  // 4 σ of the mean: 4 · 5/√20000 = 0.14
  EXPECT_NEAR(std::sqrt(squares / kCount - mean * mean), 5.0, 0.15);
}

TEST(NetworkEmulator, LossDuplicatesAndReorderingHaveTheirShares) {
  NetworkEmulator path({.loss_percent = 20.0, .reorder_percent = 10.0, .duplicate_percent = 5.0});
  int lost = 0;
  int twice = 0;
  int reordered = 0;
  constexpr int kCount = 50'000;
  for (int i = 0; i < kCount; ++i) {
    const Passage passage = path.pass(62, instantAt(0.001 * i));
    lost += passage.fate == DatagramFate::lost ? 1 : 0;
    twice += passage.out.size() == 2 ? 1 : 0;
    reordered += passage.fate == DatagramFate::passed && passage.reordered ? 1 : 0;
  }
  EXPECT_NEAR(lost, 0.20 * kCount, 400);             // 4 σ: 4 · √(50000 · 0.2 · 0.8) = 358
  EXPECT_NEAR(twice, 0.05 * 0.8 * kCount, 200);      // 4 σ: 175
  EXPECT_NEAR(reordered, 0.10 * 0.8 * kCount, 300);  // 4 σ: 243
}

TEST(NetworkEmulator, OnlyAReorderedDatagramIsOvertaken) {
  NetworkEmulator path({.delay_ms = 20.0, .jitter_ms = 8.0, .reorder_percent = 5.0});
  Instant last_in_order{};
  int overtaken = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Passage passage = path.pass(62, instantAt(0.001 * i));
    if (passage.reordered) {
      ++overtaken;
      EXPECT_GE(passage.out[0], last_in_order);
    } else {
      EXPECT_GE(passage.out[0], last_in_order);
      last_in_order = passage.out[0];
    }
  }
  EXPECT_GT(overtaken, 400);
  NetworkEmulator always({.reorder_percent = 100.0, .reorder_by_ms = 7.0});
  EXPECT_NEAR(outAfter_ms(always.pass(1, instantAt(0.0)), 0.0), 7.0, 1e-6);
}

// 62 bytes and 28 of headers are 720 bits: 11.25 ms at 64 kbit/s. Four at once: 11.25, 22.5, 33.75, 45 ms.
TEST(NetworkEmulator, TheLineTakesItsTimeAndItsQueueOverflows) {
  NetworkEmulator path({.rate_bit_per_s = 64'000.0, .queue_ms = 40.0});
  for (int i = 1; i <= 4; ++i) {
    EXPECT_NEAR(outAfter_ms(path.pass(62, instantAt(0.0)), 0.0), 11.25 * i, 1e-6);
  }
  EXPECT_EQ(path.pass(62, instantAt(0.0)).fate, DatagramFate::queue_full);  // would wait 45 ms
  EXPECT_NEAR(outAfter_ms(path.pass(62, instantAt(0.045)), 0.045), 11.25, 1e-6);
}

TEST(NetworkEmulator, TheSameSeedGivesTheSameFateAndAnotherDoesNot) {
  const NetworkSettings settings{.delay_ms = 10, .jitter_ms = 3, .loss_percent = 10, .duplicate_percent = 10};
  NetworkSettings other = settings;
  other.seed = 2;
  NetworkEmulator a(settings);
  NetworkEmulator b(settings);
  NetworkEmulator c(other);
  int different = 0;
  for (int i = 0; i < 1000; ++i) {
    const Instant now = instantAt(0.01 * i);
    const Passage from_a = a.pass(62, now);
    const Passage from_b = b.pass(62, now);
    ASSERT_EQ(from_a.out.size(), from_b.out.size());
    if (!from_a.out.empty()) {
      ASSERT_EQ(from_a.out[0], from_b.out[0]);
    }
    const Passage from_c = c.pass(62, now);
    different += from_a.fate != from_c.fate || (!from_a.out.empty() && from_a.out[0] != from_c.out[0]) ? 1 : 0;
  }
  EXPECT_GT(different, 500);
}

TEST(NetworkEmulator, ChangingOneShareLeavesTheOthersFateAlone) {
  NetworkEmulator without({.delay_ms = 50, .jitter_ms = 3});
  NetworkEmulator with({.delay_ms = 50, .jitter_ms = 3, .loss_percent = 30});
  for (int i = 0; i < 1000; ++i) {
    const Passage a = without.pass(62, instantAt(1.0 * i));
    const Passage b = with.pass(62, instantAt(1.0 * i));
    if (b.fate == DatagramFate::passed) {
      ASSERT_EQ(a.out[0], b.out[0]);
    }
  }
}

TEST(NetworkEmulator, TimeThatGoesBackCountsAsTheLast) {
  NetworkEmulator path({.delay_ms = 10});
  static_cast<void>(path.pass(1, instantAt(5.0)));
  EXPECT_NEAR(outAfter_ms(path.pass(1, instantAt(1.0)), 5.0), 10.0, 1e-6);
}

class Trace : public ::testing::Test {
 protected:
  std::string write(const std::string& text) {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::temp_directory_path() / fmt::format("fyd_{}_{}.csv", test->name(), ::getpid());
    std::ofstream(path_) << text;
    return path_.string();
  }
  ~Trace() override { std::filesystem::remove(path_); }
  std::filesystem::path path_;
};

TEST_F(Trace, OneRowForEachDatagramRepeatsAndNanIsALoss) {
  NetworkEmulator path({.trace = readDelayTrace(write("delay_ms\n10\nnan\n637\n")).value()});
  EXPECT_NEAR(outAfter_ms(path.pass(1, instantAt(0.0)), 0.0), 10.0, 1e-6);
  EXPECT_EQ(path.pass(1, instantAt(1.0)).fate, DatagramFate::lost);
  EXPECT_NEAR(outAfter_ms(path.pass(1, instantAt(2.0)), 2.0), 637.0, 1e-6);
  EXPECT_NEAR(outAfter_ms(path.pass(1, instantAt(3.0)), 3.0), 10.0, 1e-6);
}

// Rows at 0, 1 and 2 s; the last holds 1 s as the one before did, so the trace repeats every 3 s.
TEST_F(Trace, RowsWithTimesHoldUntilTheNext) {
  NetworkEmulator path({.trace = readDelayTrace(write("t_s,delay_ms\n0,10\n1,20\n2,30\n")).value()});
  for (const auto& [at_s, ms] :
       {std::pair{0.0, 10.0}, {0.99, 10.0}, {1.0, 20.0}, {2.5, 30.0}, {3.2, 10.0}, {4.1, 20.0}}) {
    EXPECT_NEAR(outAfter_ms(path.pass(1, instantAt(at_s)), at_s), ms, 1e-6) << at_s;
  }
}

TEST_F(Trace, WrongFilesAreRefusedWithFileAndLine) {
  const auto message = [&](const std::string& text) {
    const auto trace = readDelayTrace(write(text));
    return trace ? std::string("read") : trace.error().text();
  };
  EXPECT_THAT(message("delay_ms\n10\n-1\n"), ::testing::HasSubstr(".csv:3: delay -1 ms"));
  EXPECT_THAT(message("delay_ms\n10\nslow\n"), ::testing::HasSubstr("slow"));
  EXPECT_THAT(message("t_s,delay_ms\n0,1\n0,2\n"), ::testing::HasSubstr(".csv:3: time 0 s"));
  EXPECT_THAT(message("t_s,delay_ms\n1,1\n"), ::testing::HasSubstr(".csv:2: time 1 s"));
  EXPECT_THAT(message("t_s,delay_ms\n0,1\nsoon,2\n"), ::testing::HasSubstr("soon"));
  EXPECT_THAT(message("latency\n1\n"), ::testing::HasSubstr("delay_ms"));
  EXPECT_FALSE(readDelayTrace("nowhere.csv"));
}

TEST(NetworkProfile, NamedOnesAreThereAndOthersAreRefused) {
  for (const std::string_view name : kNetworkProfiles) {
    const auto profile = networkProfile(name);
    ASSERT_TRUE(profile);
    EXPECT_TRUE(checkNetwork(profile->forward));
    EXPECT_GT(profile->backward.rate_bit_per_s, 0.0);
  }
  EXPECT_EQ(networkProfile("isdn")->forward.rate_bit_per_s, 64'000.0);
  EXPECT_THAT(networkProfile("modem").error().text(), ::testing::HasSubstr("modem"));
}

TEST(NetworkProfile, SettingsOutOfRangeAreNamed) {
  const auto message = [](const NetworkSettings& settings) {
    const auto good = checkNetwork(settings);
    return good ? std::string("fine") : good.error().text();
  };
  EXPECT_THAT(message({.loss_percent = 101}), ::testing::HasSubstr("loss 101 %"));
  EXPECT_THAT(message({.delay_ms = -1}), ::testing::HasSubstr("delay -1 ms"));
  EXPECT_THAT(message({.jitter_ms = std::numeric_limits<double>::quiet_NaN()}), ::testing::HasSubstr("jitter nan"));
}

}  // namespace
}  // namespace fyd::sim
