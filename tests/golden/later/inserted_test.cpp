// The golden recordings in a program that has one parameter, one fault and one event more, in the middle of their lists:
// they are read as they were meant, and replay bit for bit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/pipeline/parameters.h"
#include "core/recording/reader/recording.h"
#include "core/replay/replay.h"

namespace fyd::recording {
namespace {

using pipeline::EventKind;
using pipeline::Fault;

const std::filesystem::path kGolden = std::filesystem::path(FYD_TEST_DATA) / "recordings";

std::unique_ptr<Recording> open(const std::filesystem::path& file) {
  auto opened = Recording::open(file.string());
  EXPECT_TRUE(opened) << file << ": " << opened.error().text();
  return opened ? std::move(*opened) : nullptr;
}

std::vector<std::filesystem::path> recordings(const std::string& arithmetic) {
  std::vector<std::filesystem::path> out;
  for (const auto& entry : std::filesystem::directory_iterator(kGolden / arithmetic)) {
    if (entry.path().extension() == ".h5") out.push_back(entry.path());
  }
  EXPECT_EQ(out.size(), 8U);  // the crashed one is a partial file
  return out;
}

std::vector<std::string> changesOf(const Recording& recording) {
  pipeline::Parameters parameters;
  const auto bound = bindParameters(parameters);
  std::vector<std::string> out;
  const auto events = recording.events();
  for (const EventRow& row : *events) {
    if (row.event.kind != EventKind::parameter_changed) continue;
    const std::size_t index = row.event.index;
    out.push_back(index < bound.size() ? fmt::format("{} = {}", bound[index].id, row.event.value) : "unknown");
  }
  return out;
}

TEST(Inserted, TheParameterStandsBetweenOthersAndItsDefaultIsNotWhatWasBefore) {
  pipeline::Parameters parameters;
  const auto bound = bindParameters(parameters);
  const Parameter* inserted = findParameter(bound, "pipeline.inserted_gain");
  ASSERT_TRUE(inserted);
  EXPECT_GT(inserted, bound.data());
  EXPECT_LT(inserted - bound.data(), 10);
  EXPECT_EQ(inserted->value(), 2.0);
  EXPECT_EQ(inserted->info.before_it_was, 1.0);
}

TEST(Inserted, TheGoldensReplayBitForBit) {
  for (const auto& file : recordings("arithmetic_2")) {
    const auto recording = open(file);
    ASSERT_TRUE(recording);
    const auto result = replay::replay(*recording, {});
    ASSERT_TRUE(result) << file << ": " << result.error().text();
    EXPECT_TRUE(result->identical) << file << ": " << result->different << " differ, first "
                                   << result->first_difference_s << " s " << result->first_difference_field;
    EXPECT_EQ(result->unknown_changes, 0U) << file;
    EXPECT_THAT(result->out_of_range, testing::IsEmpty()) << file;
  }
}

TEST(Inserted, ThoseOfTheArithmeticBeforeReplayWithinItsTolerance) {
  for (const auto& file : recordings("arithmetic_1")) {
    const auto recording = open(file);
    ASSERT_TRUE(recording);
    const auto result = replay::replay(*recording, {});
    ASSERT_TRUE(result) << file << ": " << result.error().text();
    ASSERT_TRUE(result->tolerance);
    EXPECT_EQ(result->samples, result->of) << file;
    EXPECT_EQ(result->beyond_tolerance, 0U) << file << ": " << result->max_difference_field;
    EXPECT_LT(result->max_abs_difference, 1e-12) << file;
    EXPECT_EQ(result->unknown_changes, 0U) << file;
  }
}

TEST(Inserted, WithTodaysValueOfTheParameterTheyWouldFeelOtherwise) {
  for (const char* name : {"classic", "surface", "thesis"}) {
    const auto recording = open(kGolden / "arithmetic_2" / (std::string(name) + ".h5"));
    ASSERT_TRUE(recording);
    const auto result = replay::replay(*recording, {.settings = {"pipeline.inserted_gain=2"}});
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_FALSE(result->from_rest);
    EXPECT_GT(result->different, 100U) << name;
    EXPECT_EQ(result->first_difference_field, "touch_z_mm");
  }
}

TEST(Inserted, WhatWasChangedWhileRecordingIsReadByItsName) {
  for (const char* arithmetic : {"arithmetic_1", "arithmetic_2"}) {
    const auto recording = open(kGolden / arithmetic / "changes.h5");
    ASSERT_TRUE(recording);
    EXPECT_THAT(changesOf(*recording),
                testing::ElementsAre("control.kp = 20", "texture.k_vib = 1.7", "texture.dead_zone_percent = 5",
                                     "pipeline.hand_target_N_per_mm = 0.55", "pipeline.hand_target_N_per_mm = 0.68",
                                     "texture.method = 1", "control.ki = 8"));
  }
}

TEST(Inserted, FaultsAndEventsAreReadByTheirNumbers) {
  for (const char* arithmetic : {"arithmetic_1", "arithmetic_2"}) {
    const auto held = open(kGolden / arithmetic / "held.h5");
    ASSERT_TRUE(held);
    std::vector<Fault> faults;
    const auto events = held->events();
    for (const EventRow& row : *events) {
      EXPECT_EQ(row.event.kind, EventKind::state_changed);
      if (row.event.state == pipeline::SafetyState::held) faults.push_back(row.event.fault);
    }
    EXPECT_THAT(faults, testing::ElementsAre(Fault::operator_silent));
    EXPECT_EQ(toString(Fault::operator_silent), "the window did not answer for half a second");

    const auto tare = open(kGolden / arithmetic / "tare.h5");
    ASSERT_TRUE(tare);
    const auto tared = tare->events();
    EXPECT_EQ(tared->back().event.kind, EventKind::tare_done);
  }
}

}  // namespace
}  // namespace fyd::recording
