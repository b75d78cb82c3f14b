// Steps for the tests of recordings: random ones with every hard value, plain ones, and exact comparison.
#pragma once

#include <bit>
#include <cstring>
#include <filesystem>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/session/recording.h"
#include "core/session/recording_format.h"
#include "core/session/recording_writer.h"

namespace fyd::session::samples {

/// A folder of its own that goes when the test ends.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "fyd-recording-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::permissions(path_, std::filesystem::perms::owner_all, ignored);
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] std::string file(const std::string& name = "a.h5") const { return path_ + "/" + name; }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

inline RecordingHeader header() {
  RecordingHeader header;
  header.id = "00112233445566778899aabbccddeeff";
  header.started_utc = "2026-05-04T03:02:01.000Z";
  header.started = instantAt(1000.0);
  header.operator_name = "Zoë";
  header.subject = "S07";
  header.tags = {"pilot", "velvet"};
  header.profile = "[control]\nkp=0.5\n";  // by hand: it lists nothing by which indices could be read
  header.step_state = std::string("\0\1\2\xff\0", 5);
  header.version = "test";
  return header;
}

/// A step as a quiet session has it: every value tells its row.
inline StepRecord plainStep(std::uint64_t row) {
  StepRecord record;
  record.telemetry.now = instantAt(1000.0) + std::chrono::milliseconds(row);
  record.telemetry.step = row + 1;
  record.telemetry.force_N = static_cast<double>(row) * 0.001;
  record.telemetry.indentation_mm = std::sin(static_cast<double>(row) * 0.01);
  record.inputs.now = record.telemetry.now;
  record.inputs.finger.count = row / 33;
  record.inputs.bridge.count = row / 12;
  record.inputs.bridge.value.value_mV_per_V = static_cast<double>(row / 12);
  record.inputs.motors.count = row;
  record.inputs.motors.value.current_mA = {std::sin(static_cast<double>(row)), 1.0};
  record.motors.reference_ticks = {static_cast<std::int16_t>(row % 1000), 0};
  return record;
}

class RandomSteps {
 public:
  explicit RandomSteps(std::uint64_t seed) : random_(seed) {}

  StepRecord next() {
    StepRecord r;
    pipeline::Inputs& in = r.inputs;
    in = last_;
    in.now = instantOf(word64());
    in.missed_cycles = static_cast<std::uint64_t>(word64());
    if (chance(0.2)) time(in.finger), finger(in.finger.value);
    if (chance(0.2)) {
      time(in.ir);
      in.ir.value.count = below(9);
      for (auto& count : in.ir.value.items) count = static_cast<std::uint16_t>(below(65536));
    }
    if (chance(0.2)) time(in.bridge), in.bridge.value.value_mV_per_V = real();
    if (chance(0.5)) {
      time(in.motors);
      for (std::size_t i = 0; i < control::kMotorCount; ++i) {
        in.motors.value.encoder_counts[i] = static_cast<std::uint16_t>(below(65536));
        in.motors.value.current_mA[i] = real();
        in.motors.value.position_duty_percent[i] = real();
      }
      in.motors.value.position_duty_known = chance(0.5);
    }
    if (chance(0.3)) time(in.robot.state), in.robot.state.value = {real(), {real(), real(), real()}, chance(0.5)};
    if (chance(0.1)) time(in.robot.motor_reference), in.robot.motor_reference.value = {real(), real()};
    in.robot.phase = static_cast<pipeline::LinkPhase>(below(6));
    fill(in.robot.accelerations, [&] {
      return pipeline::AccelerationSample{instantOf(word64()), {real(), real(), real()}};
    });
    fill(in.robot.commands, [&] { return static_cast<pipeline::RobotCommand>(below(12)); });
    fill(in.commands, [&] {
      return pipeline::OperatorCommand{static_cast<pipeline::OperatorAction>(below(5)), real()};
    });
    fill(in.changes, [&] { return pipeline::ParameterChange{static_cast<std::uint16_t>(below(65536)), real()}; });
    for (auto& ticks : r.motors.reference_ticks) ticks = static_cast<std::int16_t>(below(65536));
    for (auto& duty : r.motors.vibration_duty_percent) duty = real();
    r.motors.active = chance(0.5);
    telemetry(r.telemetry);
    fill(r.events, [&] {
      return pipeline::Event{static_cast<pipeline::EventKind>(below(9)), static_cast<pipeline::SafetyState>(below(6)),
                             static_cast<pipeline::Lack>(below(15)), static_cast<std::uint16_t>(below(65536)), real()};
    });
    last_ = in;
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
  template <class T>
  void time(Timed<T>& value) {
    value.taken = instantOf(word64());
    value.count = static_cast<std::uint64_t>(word64());
  }
  void finger(sensing::FingerDetection& f) {
    f = {chance(0.5), real(), real(), real(), real(), real(), real(), static_cast<sensing::FingerReason>(below(10))};
  }
  template <class Items, class Make>
  void fill(Items& items, Make&& make) {
    items = {};
    const auto full = static_cast<std::uint32_t>(Items::capacity());
    const std::uint32_t count = chance(0.8) ? 0 : chance(0.2) ? full : below(full);
    for (std::uint32_t i = 0; i < count; ++i) (void)items.push(make());
  }
  void telemetry(pipeline::TelemetrySample& s) {
    s.now = instantOf(word64());
    s.step = static_cast<std::uint64_t>(word64());
    s.state = static_cast<pipeline::SafetyState>(below(6));
    s.lack = static_cast<pipeline::Lack>(below(15));
    s.link = static_cast<pipeline::LinkPhase>(below(6));
    s.contact = chance(0.5);
    s.stiffness_observable = chance(0.5);
    s.target_clamped = chance(0.5);
    forEachField<pipeline::TelemetrySample>([&](auto, const auto& field) {
      if constexpr (std::is_same_v<FieldResult<decltype(field), pipeline::TelemetrySample>, double&>)
        field.of(s) = real();
    });
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
  const auto fail = [](const char* what) { return ::testing::AssertionFailure() << what << " differ"; };
  const pipeline::Inputs& x = a.inputs;
  const pipeline::Inputs& y = b.inputs;
  if (x.now != y.now || x.missed_cycles != y.missed_cycles || x.robot.phase != y.robot.phase) return fail("now, phase");
  if (!same(x.finger, y.finger)) return fail("fingers");
  if (!same(x.ir, y.ir)) return fail("distances");
  if (!same(x.bridge, y.bridge)) return fail("bridges");
  if (!same(x.motors, y.motors)) return fail("motors' reports");
  if (!same(x.robot.state, y.robot.state)) return fail("robot's states");
  if (!same(x.robot.motor_reference, y.robot.motor_reference)) return fail("robot's references");
  if (!sameAll(x.robot.accelerations, y.robot.accelerations)) return fail("accelerations");
  if (!sameAll(x.robot.commands, y.robot.commands)) return fail("robot's commands");
  if (!sameAll(x.commands, y.commands)) return fail("commands");
  if (!sameAll(x.changes, y.changes)) return fail("changes");
  if (!same(a.motors, b.motors)) return fail("motor commands");
  if (!same(a.telemetry, b.telemetry)) return fail("telemetry");
  if (!std::equal(a.events.begin(), a.events.end(), b.events.begin(), b.events.end(), [](const auto& e, const auto& f) {
        return same(EventRow{{}, e}, EventRow{{}, f});
      }))
    return fail("events");
  return ::testing::AssertionSuccess();
}

}  // namespace fyd::session::samples
