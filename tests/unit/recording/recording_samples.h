// Steps for the tests of recordings: random ones with every hard value, plain ones, and exact comparison.
#pragma once

#include <bit>
#include <cstring>
#include <filesystem>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "core/recording/format/recording_format.h"
#include "core/recording/format/step_row.h"
#include "core/recording/reader/recording.h"
#include "core/recording/writer/recording_writer.h"
#include "tests/temporary_folder.h"

namespace fyd::recording::samples {

using fyd::Folder;

inline RecordingHeader header() {
  RecordingHeader header;
  header.id = "00112233445566778899aabbccddeeff";
  header.started_utc = "2026-05-04T03:02:01.000Z";
  header.started = instantAt(1000.0);
  header.operator_name = "Zoë";
  header.subject = "S07";
  header.tags = {"pilot", "velvet"};
  header.profile = "[control]\nkp=0.5\n";  // written by hand, without the list of parameters that indices refer to
  header.step_state = std::string("\0\1\2\xff\0", 5);
  header.version = "test";
  return header;
}

/// A step of a quiet session, with values that identify its row.
inline StepRecord plainStep(std::uint64_t row) {
  StepRecord record;
  record.telemetry.now = instantAt(1000.0) + std::chrono::milliseconds(row);
  record.telemetry.step = row + 1;
  record.telemetry.force_N = static_cast<double>(row) * 0.001;
  record.telemetry.indentation_mm = std::sin(static_cast<double>(row) * 0.01);
  record.inputs.now = record.telemetry.now;
  record.inputs.finger.count = row / 33;
  record.inputs.bridge.count = row / 12;
  record.inputs.bridge.value.value_mV_per_V = static_cast<double>(record.inputs.bridge.count);
  record.inputs.motors.count = row;
  record.inputs.motors.value.current_mA = {std::sin(static_cast<double>(row)), 1.0};
  record.motors.reference_ticks = {static_cast<std::int16_t>(row % 1000), 0};
  return record;
}

/// A closed recording of plain steps, in place of what has the name.
inline void record(const std::string& file, std::uint64_t rows, const RecordingHeader& header = samples::header()) {
  std::filesystem::remove(file);
  auto writer = RecordingWriter::create(file, header);
  ASSERT_TRUE(writer) << writer.error().text();
  for (std::uint64_t row = 0; row < rows; ++row) ASSERT_TRUE((*writer)->append(plainStep(row)));
  ASSERT_TRUE((*writer)->close());
}

class RandomSteps {
 public:
  explicit RandomSteps(std::uint64_t seed) : random_(seed) {}

  StepRecord next() {
    StepRecord r;
    r.inputs = last_;
    forEachField<pipeline::Inputs>([&](auto, const auto& field) { random(field.of(r.inputs)); });
    forEachOf(kInputTables, [&](auto, const auto& table) {
      auto& value = table.of(r.inputs);
      if constexpr (kIsList<std::remove_cvref_t<decltype(value)>>)
        fill(value);
      else if (chance(0.3))
        randomStruct(value);
    });
    randomStruct(r.motors);
    randomStruct(r.telemetry);
    fill(r.events);
    last_ = r.inputs;
    return r;
  }

 private:
  bool chance(double p) { return std::bernoulli_distribution(p)(random_); }
  std::uint32_t below(std::uint32_t n) { return std::uniform_int_distribution<std::uint32_t>(0, n - 1)(random_); }
  std::int64_t word64() { return std::bit_cast<std::int64_t>(random_()); }
  /// Any bit pattern: numbers large and small, infinities, NaNs with any payload.
  double real() {
    constexpr double kHard[] = {0.0, -0.0, INFINITY, -INFINITY, NAN, 1e-310, 1.7e308, -1.7e308, 1.0};
    if (chance(0.4)) return kHard[below(9)];
    return std::bit_cast<double>(random_());
  }
  void random(double& value) { value = real(); }
  void random(bool& value) { value = chance(0.5); }
  void random(Instant& value) { value = instantOf(word64()); }
  template <class T>
  void random(T& value) {  // an enum value may be unknown to this program
    value = static_cast<T>(std::is_enum_v<T> ? below(256) : random_());
  }
  template <class T, std::size_t N>
  void random(std::array<T, N>& values) {
    for (T& value : values) random(value);
  }
  template <class T, std::size_t N>
  void random(Batch<T, N>& list) {
    random(list.items);
    list.count = below(N + 1);
  }
  template <class T>
  void randomStruct(T& value) {
    forEachField<T>([&](auto, const auto& field) {
      if constexpr (std::is_lvalue_reference_v<FieldResult<decltype(field), T>>) random(field.of(value));
    });
  }
  template <class Items>
  void fill(Items& items) {
    items = {};
    const auto full = static_cast<std::uint32_t>(Items::capacity());
    items.count = chance(0.8) ? 0 : chance(0.2) ? full : below(full);
    for (auto& item : items.view()) randomStruct(item);
  }

  std::mt19937_64 random_;
  pipeline::Inputs last_;
};

/// Bit for bit, through the rows, which hold every member.
template <class T>
bool same(const T& a, const T& b) {
  return toRow(a) == toRow(b);
}
template <class Items>
bool sameAll(const Items& a, const Items& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) { return same(x, y); });
}

inline ::testing::AssertionResult sameRecord(const StepRecord& a, const StepRecord& b) {
  std::string differs;
  const auto see = [&](bool equal, std::string_view what) {
    if (!equal) differs += fmt::format("{} ", what);
  };
  see(toRow(WrittenStepRow{a.inputs, {}}) == toRow(WrittenStepRow{b.inputs, {}}), "numbers");
  forEachOf(kInputTables, [&](auto, const auto& table) {
    const auto& value = table.of(a.inputs);
    if constexpr (kIsList<std::remove_cvref_t<decltype(value)>>)
      see(sameAll(value, table.of(b.inputs)), table.path);
    else
      see(same(value, table.of(b.inputs)), table.path);
  });
  see(same(a.motors, b.motors), "motor commands");
  see(same(a.telemetry, b.telemetry), "telemetry");
  see(sameAll(a.events, b.events), "events");
  if (!differs.empty()) return ::testing::AssertionFailure() << differs << "differ";
  return ::testing::AssertionSuccess();
}

}  // namespace fyd::recording::samples
