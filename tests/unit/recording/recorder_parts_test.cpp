// Parts of the recorder: packed steps, the last seconds in memory, pictures, trials.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include <opencv2/imgcodecs.hpp>

#include "core/experiment/trials.h"
#include "core/recording/format/step_compare.h"
#include "core/recording/writer/disk_space.h"
#include "core/recording/writer/picture_history.h"
#include "core/recording/writer/step_history.h"

namespace fyd::recording {
namespace {

using namespace std::chrono_literals;

template <class T, std::size_t Capacity, class Make>
void fill(Batch<T, Capacity>& batch, Make make) {
  while (!batch.full()) (void)batch.push(make(batch.size()));
}

/// Every list full, every value another.
void fillStep(pipeline::Inputs& in, pipeline::Outputs& out) {
  in.now = instantAt(12.345678901);
  in.missed_cycles = 7;
  in.finger.set({.contact = true, .area_px = 1.5, .x_mm = -3.25, .quality = 0.5}, instantAt(12.3));
  sensing::IrCounts counts;
  fill(counts, [](std::size_t i) { return static_cast<std::uint16_t>(4095 - i); });
  in.ir.set(counts, instantAt(12.2));
  in.bridge.set({.value_mV_per_V = 0.1}, instantAt(12.1));
  in.motors.set({.encoder_counts = {1, 4095}, .current_mA = {-2.5, 3.5}, .position_duty_known = true}, instantAt(12.0));
  in.robot.phase = pipeline::LinkPhase::running;
  in.robot.state.set({.stiffness_N_per_mm = 0.6, .position_mm = {1, 2, 3}, .button = true}, instantAt(11.0));
  in.robot.motor_reference.set({.first_ticks = 10, .second_ticks = -10}, instantAt(10.0));
  fill(in.robot.accelerations, [](std::size_t i) {
    return texture::AccelerationSample{.taken = instantAt(double(i)), .acceleration_g = {double(i), 0.5, -1.0}};
  });
  fill(in.robot.commands, [](std::size_t i) { return static_cast<pipeline::RobotCommand>(i % 12); });
  fill(in.commands, [](std::size_t i) {
    return pipeline::OperatorCommand{.action = pipeline::OperatorAction::tare, .value = double(i)};
  });
  fill(in.changes, [](std::size_t i) {
    return pipeline::ParameterChange{.index = static_cast<std::uint16_t>(i), .value = 0.25 * double(i)};
  });
  out.motors = {.reference_ticks = {-4200, 4200}, .vibration_duty_percent = {-100, 99.5}, .active = true};
  out.telemetry.now = in.now;
  out.telemetry.step = 99;
  out.telemetry.force_N = 1.25;
  fill(out.events, [](std::size_t i) {
    return pipeline::Event{.kind = pipeline::EventKind::parameter_changed, .index = static_cast<std::uint16_t>(i)};
  });
}

std::vector<std::byte> packed(const pipeline::Inputs& in, const pipeline::Outputs& out) {
  std::vector<std::byte> bytes(kLargestPackedStep);
  bytes.resize(packStep({.inputs = in, .outputs = out}, bytes));
  return bytes;
}

TEST(PackedStep, HoldsAStepWithEveryListFull) {
  pipeline::Inputs in;
  pipeline::Outputs out;
  fillStep(in, out);
  const auto bytes = packed(in, out);
  EXPECT_LE(bytes.size(), kLargestPackedStep);
  EXPECT_EQ(packedSize(bytes), bytes.size());
  StepRecord record;
  unpackStep(bytes, record);
  EXPECT_EQ(record.inputs.now, in.now);
  EXPECT_EQ(record.inputs.missed_cycles, 7U);
  EXPECT_EQ(record.inputs.finger.value.x_mm, -3.25);
  EXPECT_EQ(record.inputs.finger.taken, in.finger.taken);
  EXPECT_THAT(record.inputs.ir.value.view(), testing::ElementsAreArray(in.ir.value.view()));
  EXPECT_EQ(record.inputs.motors.value.encoder_counts[1], 4095);
  EXPECT_TRUE(record.inputs.robot.state.value.button);
  EXPECT_EQ(record.inputs.robot.motor_reference.value.second_ticks, -10);
  ASSERT_EQ(record.inputs.robot.accelerations.size(), pipeline::kMaximumAccelerationsPerStep);
  EXPECT_EQ(record.inputs.robot.accelerations[63].acceleration_g.x, 63.0);
  EXPECT_EQ(record.inputs.robot.commands[3], in.robot.commands[3]);
  EXPECT_EQ(record.inputs.commands[15].value, 15.0);
  EXPECT_EQ(record.inputs.changes[15].index, 15);
  EXPECT_EQ(record.events[31].index, 31);
  EXPECT_TRUE(sameStep(record.telemetry, record.motors, out.telemetry, out.motors));
}

TEST(PackedStep, OfAnUsualStepIsAQuarterOfTheRecord) {
  const pipeline::Inputs in;
  const pipeline::Outputs out;
  const auto bytes = packed(in, out);
  EXPECT_LT(bytes.size() * 4, sizeof(StepRecord));
  StepRecord record;
  pipeline::Outputs full;
  fillStep(record.inputs, full);
  unpackStep(bytes, record);
  EXPECT_TRUE(record.inputs.robot.accelerations.empty());
  EXPECT_TRUE(record.inputs.commands.empty());
  EXPECT_TRUE(record.events.empty());
}

TEST(StepCompare, SeesOneBitAndTellsNoneFromANumber) {
  pipeline::TelemetrySample a;
  pipeline::TelemetrySample b;
  const control::MotorCommand motors;
  EXPECT_TRUE(sameStep(a, motors, b, motors)) << "fields without a value are the same";
  b.force_N = 1.0;
  a.force_N = std::nextafter(1.0, 2.0);
  auto difference = compareSteps(a, motors, b, motors);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->field, "force_N");
  EXPECT_GT(difference->absolute, 0.0);
  a.force_N = pipeline::kNone;
  difference = compareSteps(a, motors, b, motors);
  ASSERT_TRUE(difference);
  EXPECT_TRUE(std::isinf(difference->absolute));
  control::MotorCommand other;
  other.reference_ticks[1] = 3;
  difference = compareSteps(b, motors, b, other);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->field, "motors");
  EXPECT_EQ(difference->absolute, 3.0);
}

class Steps : public testing::Test {
 protected:
  void add(int count) {
    for (int i = 0; i < count; ++i) {
      if (history.chunkIsDue()) history.beginChunk({.state = std::to_string(next), .parameters = {}});
      pipeline::Inputs in;
      in.now = instantAt(100.0 + 1e-3 * static_cast<double>(next));
      pipeline::Outputs out;
      out.telemetry.step = next++;
      history.add(packed(in, out), in.now);
    }
  }
  std::vector<std::uint64_t> readAll() {
    std::vector<std::uint64_t> out;
    StepRecord record;
    while (history.read(record)) out.push_back(record.telemetry.step);
    return out;
  }
  StepHistory history;
  std::uint64_t next = 1;
};

TEST_F(Steps, KeepTheirOrderAndBeginAtASnapshot) {
  add(2500);
  ASSERT_TRUE(history.start());
  EXPECT_EQ(history.start()->snapshot->state, "1");
  history.readFromStart();
  EXPECT_EQ(history.unread(), 2500U);
  const auto read = readAll();
  ASSERT_EQ(read.size(), 2500U);
  EXPECT_EQ(read.front(), 1U);
  EXPECT_EQ(read.back(), 2500U);
  add(700);
  EXPECT_EQ(readAll().size(), 700U) << "what comes while it is read is read as well";
}

TEST_F(Steps, AChunkWithoutOneIsNoStart) {
  history.beginChunk({.state = "before", .parameters = {}});
  EXPECT_FALSE(history.start());
  history.add(packed({}, {}), instantAt(7.0));
  ASSERT_TRUE(history.start());
  EXPECT_EQ(history.start()->when, instantAt(7.0));
  EXPECT_EQ(history.start()->snapshot->state, "before");
}

TEST_F(Steps, WhatIsUnreadCountsFromTheReadersPlaceInWhicheverChunk) {
  constexpr int kSteps = 2500;
  add(kSteps);
  history.readFromStart();
  StepRecord record;
  for (int unread = kSteps - 1; unread >= 0; --unread) {
    ASSERT_TRUE(history.read(record));
    ASSERT_EQ(history.unread(), static_cast<std::uint64_t>(unread));
  }
  EXPECT_FALSE(history.read(record));
}

TEST_F(Steps, OldOnesGoAChunkAtATime) {
  add(5000);
  EXPECT_EQ(history.trim(instantAt(100.0 + 2.5), 100), 0U) << "nobody was to read them";
  ASSERT_TRUE(history.start());
  EXPECT_EQ(history.start()->snapshot->state, "2001");
  history.readFromStart();
  EXPECT_EQ(readAll().front(), 2001U);
}

TEST_F(Steps, AReaderThatIsBehindHoldsThemUntilThereAreTooMany) {
  add(3000);
  history.readFromStart();
  StepRecord record;
  ASSERT_TRUE(history.read(record));
  add(3000);
  EXPECT_EQ(history.trim(instantAt(200.0), 10), 0U);
  ASSERT_TRUE(history.read(record));
  EXPECT_EQ(record.telemetry.step, 2U);
  add(9000);
  EXPECT_EQ(history.trim(instantAt(200.0), 10), 4998U) << "two were read";
  ASSERT_TRUE(history.read(record));
  EXPECT_EQ(record.telemetry.step, 5001U) << "the disk was too slow: a gap";
}

TEST(Pictures, KeepTheRegionExactly) {
  cv::Mat picture(60, 80, CV_8UC1);
  cv::randu(picture, 0, 255);
  const cv::Rect region(10, 5, 40, 30);
  const EncodedPicture encoded = encodePicture({.picture = picture, .region_px = region, .number = 4});
  const cv::Mat whole = cv::imdecode(encoded.whole, cv::IMREAD_UNCHANGED);
  const cv::Mat inside = cv::imdecode(encoded.region, cv::IMREAD_UNCHANGED);
  EXPECT_EQ(whole.size(), picture.size());
  ASSERT_EQ(inside.size(), region.size());
  EXPECT_EQ(cv::norm(inside, picture(region), cv::NORM_INF), 0.0);
  EXPECT_EQ(encoded.number, 4U);
}

TEST(Pictures, ARegionOutsideOrAnEmptyPictureIsLeftOut) {
  const cv::Mat picture(60, 80, CV_8UC1, cv::Scalar(7));
  EXPECT_TRUE(encodePicture({.picture = picture, .region_px = {70, 5, 40, 30}}).region.empty());
  EXPECT_FALSE(encodePicture({.picture = picture, .region_px = {70, 5, 40, 30}}).whole.empty());
  EXPECT_TRUE(encodePicture({}).whole.empty());
}

TEST(Pictures, LargeOnesGoBackLessFar) {
  PictureHistory history;
  const cv::Mat large(2000, 2500, CV_8UC1, cv::Scalar(1));  // 5 MB
  for (int i = 1; i <= 12; ++i) {
    history.add({.picture = large, .taken = instantAt(i), .number = static_cast<std::uint64_t>(i)});
  }
  history.readFrom(instantAt(0));
  const auto first = history.read(instantAt(100));
  ASSERT_TRUE(first);
  EXPECT_EQ(first->number, 5U) << "8 of them are 40 MB";
  EXPECT_FALSE(history.read(instantAt(5.5))) << "number 6 was taken later";
  history.add({.picture = large, .taken = instantAt(13), .number = 13});
  history.add({.picture = large, .taken = instantAt(14), .number = 14});
  EXPECT_EQ(history.lost(), 1U) << "number 5 was read, number 6 was not";
  EXPECT_EQ(history.read(instantAt(100))->number, 7U);
}

TEST(DiskSpace, IsTheFoldersAndAMissingFolderIsNamed) {
  EXPECT_GT(freeBytes("/tmp/x.h5").value_or(0), 0U);
  const auto missing = freeBytes("/nowhere/at/all/x.h5");
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().text(), testing::HasSubstr("/nowhere/at/all"));
}

TEST(DiskSpace, GrowthIsThatOfTheLastTenSeconds) {
  GrowthRate growth;
  EXPECT_EQ(growth.bytes_per_s(), 0.0);
  for (int i = 0; i <= 60; ++i) growth.observe(instantAt(i), static_cast<std::uint64_t>(i < 40 ? 0 : (i - 40) * 1000));
  EXPECT_NEAR(growth.bytes_per_s(), 1000.0, 1.0);
}

TEST(Trials, EachBlockHoldsEveryConditionOnceAndNoneTwiceRunning) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto trials = experiment::orderTrials({"a", "b", "c"}, 6, seed);
    ASSERT_TRUE(trials);
    ASSERT_EQ(trials->size(), 18U);
    std::map<std::uint32_t, std::set<std::string>> blocks;
    for (const experiment::Trial& trial : *trials) blocks[trial.block].insert(trial.condition);
    for (const auto& [block, conditions] : blocks) EXPECT_EQ(conditions.size(), 3U) << seed << " block " << block;
    for (std::size_t i = 1; i < trials->size(); ++i) {
      EXPECT_NE((*trials)[i].condition, (*trials)[i - 1].condition) << seed;
      EXPECT_EQ((*trials)[i].number, i + 1);
    }
  }
}

TEST(Trials, OfTwoConditionsTheNextCannotBeForetold) {
  // A block of four has six orders. Of the steps within one, four of six change the condition; of those between two, one
  // of two: (3 · 2/3 + 1/2) / 4 = 0.625. In turns it would be 1.
  int changes = 0, steps = 0;
  std::map<std::string, int> orders;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto trials = experiment::orderTrials({"a", "b"}, 20, seed);
    ASSERT_TRUE(trials);
    ASSERT_EQ(trials->size(), 40U);
    std::map<std::uint32_t, std::string> blocks;
    for (const experiment::Trial& trial : *trials) blocks[trial.block] += trial.condition;
    EXPECT_EQ(blocks.size(), 10U);
    for (const auto& [number, block] : blocks) {
      EXPECT_EQ(block.size(), 4U) << seed;
      EXPECT_EQ(std::ranges::count(block, 'a'), 2) << seed << " block " << number;
      ++orders[block];
    }
    for (std::size_t i = 1; i < trials->size(); ++i, ++steps)
      changes += (*trials)[i].condition != (*trials)[i - 1].condition ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(changes) / steps, 0.625, 0.03);
  ASSERT_EQ(orders.size(), 6U);
  for (const auto& [order, count] : orders) EXPECT_NEAR(count, 2000.0 / 6.0, 85.0) << order;  // 5 σ
}

TEST(Trials, OfTwoConditionsAnOddNumberOfRepetitionsIsEvenToo) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto trials = experiment::orderTrials({"a", "b"}, 3, seed);
    ASSERT_TRUE(trials);
    ASSERT_EQ(trials->size(), 6U);
    EXPECT_EQ(std::ranges::count(*trials, "a", &experiment::Trial::condition), 3);
    EXPECT_EQ((*trials)[3].block, 1U);
    EXPECT_EQ((*trials)[4].block, 2U);
    EXPECT_NE((*trials)[4].condition, (*trials)[5].condition);
  }
  EXPECT_EQ(orderTrials({"a", "b"}, 5, 1, experiment::TrialOrder::latin_square)->size(), 10U);
}

TEST(Trials, TheSeedGivesTheOrderAgainAndAnotherSeedAnother) {
  const std::vector<std::string> conditions{"a", "b", "c", "d", "e"};
  EXPECT_EQ(*experiment::orderTrials(conditions, 4, 7), *experiment::orderTrials(conditions, 4, 7));
  EXPECT_NE(*experiment::orderTrials(conditions, 4, 7), *experiment::orderTrials(conditions, 4, 8));
}

TEST(Trials, AWilliamsSquareBalancesWhatCameJustBefore) {
  for (const std::size_t n : {2U, 3U, 4U, 5U, 6U}) {
    std::vector<std::string> conditions;
    conditions.reserve(n);
    for (std::size_t i = 0; i < n; ++i) conditions.push_back(std::string(1, static_cast<char>('a' + i)));
    const std::size_t rows = n % 2 == 0 ? n : 2 * n;
    const auto trials = orderTrials(conditions, rows, 3, experiment::TrialOrder::latin_square);
    ASSERT_TRUE(trials);
    std::map<std::string, int> pairs;
    std::map<std::string, int> places;
    for (std::size_t i = 0; i < trials->size(); ++i) {
      ++places[(*trials)[i].condition + std::to_string(i % n)];
      if (i % n > 0) ++pairs[(*trials)[i - 1].condition + (*trials)[i].condition];
    }
    EXPECT_EQ(pairs.size(), n * (n - 1));
    EXPECT_EQ(places.size(), n * n);
    const int each = static_cast<int>(rows / n);
    for (const auto& [pair, count] : pairs) EXPECT_EQ(count, each) << n << pair;
    for (const auto& [place, count] : places) EXPECT_EQ(count, each) << n << place;
  }
}

TEST(Trials, BadListsAreRefusedByName) {
  EXPECT_FALSE(experiment::orderTrials({}, 1, 1));
  EXPECT_FALSE(experiment::orderTrials({"a", ""}, 1, 1));
  EXPECT_FALSE(experiment::orderTrials({"a"}, 0, 1));
  EXPECT_FALSE(experiment::orderTrials({"a"}, experiment::kMaximumRepetitions + 1, 1));
  const auto twice = experiment::orderTrials({"a", "b", "a"}, 1, 1);
  ASSERT_FALSE(twice);
  EXPECT_THAT(twice.error().text(), testing::HasSubstr("'a'"));
  EXPECT_EQ(experiment::orderTrials({"a"}, 3, 1)->size(), 3U) << "one condition alone has to follow itself";
  EXPECT_EQ(experiment::markerText({.number = 3, .block = 1, .condition = "soft"}), "3 soft");
}

}  // namespace
}  // namespace fyd::recording
