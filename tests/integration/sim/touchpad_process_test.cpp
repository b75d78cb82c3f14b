// The real drivers against the simulator's servers: TCP sockets and pseudo-terminals, with every fault.
#include "core/sim/server/touchpad_process.h"

#include <filesystem>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <opencv2/core.hpp>

#include "core/device/camera/camera_source.h"
#include "core/device/in_use.h"
#include "core/device/touchpad/combined_touchpad.h"
#include "core/device/touchpad/modbus_touchpad.h"
#include "core/device/touchpad/touchpad_source.h"
#include "tests/wait.h"

namespace fyd::sim {
namespace {

using device::ModbusTouchpad;
using testing::HasSubstr;

enum class Line : std::uint8_t { tcp, rtu };

/// Patient with a machine that stands still; what a fault must break takes longer.
device::DeviceParameters patient() {
  device::DeviceParameters parameters;
  parameters.response_timeout_ms = 1500.0;
  parameters.qbmove_timeout_ms = 200.0;
  parameters.watchdog_ms = 1000.0;
  return parameters;
}

/// Gives a late or missing answer up before it comes.
device::DeviceParameters quick() {
  device::DeviceParameters parameters = patient();
  parameters.response_timeout_ms = 100.0;
  parameters.watchdog_ms = 400.0;
  return parameters;
}

// A port that comes back: as a source address nobody else uses this one, so that nobody is given the port meanwhile.
constexpr const char* kOwnAddress = "127.0.0.77:0";

std::string scratch(const char* name) { return fmt::format("{}fyd-{}-{}", testing::TempDir(), name, ::getpid()); }

struct Rig {
  explicit Rig(Line line, const device::DeviceParameters& parameters = patient()) {
    TouchpadProcessOptions options;
    if (line == Line::tcp)
      options.modbus_tcp = *protocol::parseEndpoint("127.0.0.1:0");
    else
      options.modbus_rtu = scratch("rtu");
    process = std::move(*TouchpadProcess::start(std::move(options)));
    address = process->addresses().front();
    touchpad = std::make_unique<ModbusTouchpad>(*device::parseModbusAddress(address), parameters);
  }
  Result<device::TouchpadReadings> exchange(bool active = false) {
    auto done = touchpad->exchange({.reference_ticks = {2000, -2000}, .active = active}, Clock::now());
    failed += done ? 0 : 1;
    if (!done) problem = done.error().text();
    return done;
  }
  /// Exchanges every few milliseconds.
  template <class Holds>
  testing::AssertionResult exchangeUntil(std::string_view what, bool active, Holds&& holds) {
    auto came = comesTrue(what, [&] {
      (void)exchange(active);
      return holds();
    });
    if (!came) came << "; last: " << problem << "; complaint: " << touchpad->complaint().text();
    return came;
  }
  testing::AssertionResult exchangeTimes(int count, bool active) {
    for (int i = 0; i < count; ++i) {
      if (const auto done = exchange(active); !done) return testing::AssertionFailure() << done.error().text();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return testing::AssertionSuccess();
  }
  [[nodiscard]] bool motorsOn() const { return process->electronics().figures().motors_on; }
  /// As by an operator: motors that a standstill of the machine switched off are given free first.
  testing::AssertionResult switchOn() {
    return comesTrue("motors that are on", [&] {
      (void)exchange(touchpad->complaint().empty());
      return motorsOn();
    });
  }
  /// A fault breaks an exchange, and its end heals the next.
  testing::AssertionResult meets(TouchpadFault fault, double seconds, bool active) {
    process->inject(fault, seconds);
    const int before = failed;
    if (auto broken = exchangeUntil("a failed exchange", active, [&] { return failed > before; }); !broken)
      return broken;
    return exchangeUntil("the next good exchange", active,
                         [&, last = failed]() mutable { return std::exchange(last, failed) == failed; });
  }
  std::unique_ptr<TouchpadProcess> process;
  std::string address;
  std::unique_ptr<ModbusTouchpad> touchpad;
  std::string problem;
  int failed = 0;
};

class BothLines : public testing::TestWithParam<Line> {};
INSTANTIATE_TEST_SUITE_P(Lines, BothLines, testing::Values(Line::tcp, Line::rtu),
                         [](const auto& line) { return line.param == Line::tcp ? "tcp" : "rtu"; });

TEST_P(BothLines, TheMotorsFollowAndTheSensorsTell) {
  Rig rig(GetParam());
  const double target_deg = 2000 / control::kTicksPerDegree;
  Result<device::TouchpadReadings> readings = fail("none yet");
  Instant asked{};
  ASSERT_TRUE(comesTrue("the motor at its reference", [&] {
    asked = Clock::now();
    readings = rig.exchange(true);
    return readings && readings->ir.count > 5U && readings->bridge.count > 10U &&
           std::abs(readings->motors.value.encoder_counts[0] / control::kEncoderCountsPerDegree - target_deg) < 8.0;
  })) << rig.problem;
  EXPECT_EQ(rig.failed, 0) << rig.problem;
  EXPECT_EQ(readings->ir.value.size(), 3U);
  EXPECT_LT(toMilliseconds(asked - readings->ir.taken), 200.0);
  EXPECT_TRUE(rig.motorsOn());
}

TEST_P(BothLines, ALateReplyIsNeverTakenForAFreshOne) {
  Rig rig(GetParam(), quick());
  ASSERT_TRUE(rig.meets(TouchpadFault::late_reply, 0.0, false)) << "the late one at least fails, and then it goes on";
  // What is taken after the trap belongs to its own question: the uptime is today's.
  const std::uint32_t uptime_us = rig.touchpad->state().uptime_us;
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  ASSERT_TRUE(comesTrue("an exchange", [&] { return rig.exchange().has_value(); })) << rig.problem;
  EXPECT_GE(rig.touchpad->state().uptime_us - uptime_us, 49'000U);
}

TEST_P(BothLines, SilenceSwitchesTheMotorsOffAtTheDeviceAndTheyStayOff) {
  Rig rig(GetParam(), quick());
  ASSERT_TRUE(rig.switchOn());
  rig.process->inject(TouchpadFault::silence, 1.0);
  ASSERT_TRUE(rig.exchangeUntil("the device's watchdog", true, [&] { return !rig.motorsOn(); }));
  ASSERT_TRUE(rig.exchangeUntil("a complaint of the motors", true, [&] {
    return rig.touchpad->complaint().text().find("mend that, then arm again") != std::string::npos;
  }));
  for (int i = 0; i < 50; ++i) {
    (void)rig.exchange(true);
    ASSERT_FALSE(rig.motorsOn()) << "by themselves";
  }
  EXPECT_TRUE(rig.switchOn()) << "by the operator's act";
}

TEST_P(BothLines, GarbageIsRefusedAndTheEndOfItHeals) {
  Rig rig(GetParam(), quick());
  ASSERT_TRUE(comesTrue("an exchange", [&] { return rig.exchange().has_value(); })) << rig.problem;
  EXPECT_TRUE(rig.meets(TouchpadFault::garbage, 0.2, false));
  EXPECT_TRUE(comesTrue("ten good exchanges", [&] { return rig.exchangeTimes(10, false); })) << rig.problem;
}

TEST_P(BothLines, ABrownOutIsComplainedOf) {
  Rig rig(GetParam(), quick());
  ASSERT_TRUE(rig.switchOn());
  EXPECT_TRUE(rig.meets(TouchpadFault::brown_out, 0.15, true));
  EXPECT_TRUE(rig.exchangeUntil("a complaint of the motors", true, [&] {
    return rig.touchpad->complaint().text().find("arm again") != std::string::npos;
  }));
  EXPECT_FALSE(rig.motorsOn());
}

TEST_P(BothLines, AStuckSensorAndAJumpingEncoderShowWhatTheySay) {
  Rig rig(GetParam());
  ASSERT_TRUE(rig.exchange());
  const int before = rig.touchpad->state().motors.encoder_counts[0];
  rig.process->inject(TouchpadFault::stuck_sensor, 600.0);
  rig.process->inject(TouchpadFault::encoder_jump, 600.0);
  ASSERT_TRUE(rig.exchangeTimes(5, false));
  const std::uint16_t stuck = rig.touchpad->state().ir[0];
  const std::uint16_t count = rig.touchpad->state().ir_count;
  ASSERT_TRUE(rig.exchangeUntil("more samples to be counted", false,
                                [&] { return rig.touchpad->state().ir_count - count > 3; }));
  EXPECT_EQ(rig.touchpad->state().ir[0], stuck);
  EXPECT_NEAR((rig.touchpad->state().motors.encoder_counts[0] - before + 4096) % 4096, 512, 2);
}

TEST_P(BothLines, BatchesOfDutiesArrive) {
  Rig rig(GetParam());
  ASSERT_TRUE(rig.switchOn());
  const auto arrived = [&] { return rig.process->electronics().figures().vibration_peak_percent >= 60.0; };
  EXPECT_TRUE(comesTrue("a batch", [&] {
    const std::array<device::VibrationDuty, 5> duties = {{{0, 0}, {20, 20}, {40, -40}, {60, 60}, {0, 0}}};
    rig.touchpad->queueVibration(duties);
    (void)rig.exchange(rig.touchpad->complaint().empty());
    return arrived();
  })) << rig.problem;
  EXPECT_EQ(rig.process->electronics().figures().vibration_peak_percent, 60.0);
}

TEST(TouchpadProcess, ASecondMasterIsRefusedWithAReasonAndTheFirstNotices) {
  Rig rig(Line::tcp);
  ASSERT_TRUE(rig.exchange());
  ModbusTouchpad second(*device::parseModbusAddress(rig.address), patient());
  const auto refused = second.exchange({}, Clock::now());
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), HasSubstr("another program drives its motors"));
  EXPECT_TRUE(device::isInUse(refused.error().message));
  EXPECT_TRUE(rig.exchange());
  EXPECT_GE(rig.process->electronics().figures().refused_writes, 1U);
}

TEST(TouchpadProcess, ComesBackEachTimeTheServerIsKilledInTheMiddle) {
  TouchpadProcessOptions options;
  options.modbus_tcp = *protocol::parseEndpoint(kOwnAddress);
  auto process = *TouchpadProcess::start(options);
  options.modbus_tcp->port = process->modbusPort();
  ModbusTouchpad touchpad(*device::parseModbusAddress(process->addresses().front()), quick());
  for (int kill = 0; kill < 200; ++kill) {
    std::jthread killer([&] {
      std::this_thread::sleep_for(std::chrono::microseconds(500 + 137 * (kill % 20)));
      process.reset();
    });
    while (touchpad.exchange({}, Clock::now())) {
    }
    killer.join();
    EXPECT_FALSE(touchpad.exchange({}, Clock::now()));
    auto next = TouchpadProcess::start(options);
    ASSERT_TRUE(next) << next.error().text();
    process = std::move(*next);
    ASSERT_TRUE(comesTrue("an exchange", [&] { return touchpad.exchange({}, Clock::now()).has_value(); })) << kill;
  }
}

TEST(TouchpadProcess, TheMotorBoardTakesTheMotorsAndTheSensorsStayOnModbus) {
  TouchpadProcessOptions options;
  options.modbus_tcp = *protocol::parseEndpoint("127.0.0.1:0");
  options.qbmove = scratch("qbmove");
  options.board.vibration_opcode = 145;
  const auto process = *TouchpadProcess::start(options);
  device::DeviceParameters parameters = patient();
  parameters.qbmove_vibration_opcode = 145;
  auto sensors = device::openTouchpad(process->addresses().front(), parameters);
  auto touchpad = *device::withMotors(std::move(*sensors), "qbmove:" + options.qbmove, parameters);
  ASSERT_TRUE(comesTrue("motors at their reference, samples and the vibration", [&] {
    const auto readings = touchpad->exchange(
        {.reference_ticks = {2000, -2000}, .vibration_duty_percent = {30, 30}, .active = touchpad->complaint().empty()},
        Clock::now());
    const double target_deg = 2000 / control::kTicksPerDegree;
    return readings && readings->ir.count > 5U && touchpad->complaint().empty() &&
           std::abs(readings->motors.value.encoder_counts[0] / control::kEncoderCountsPerDegree - target_deg) < 8.0 &&
           process->electronics().figures().vibration_peak_percent > 0.0 && process->electronics().figures().motors_on;
  })) << touchpad->complaint().text();
  const auto figures = process->electronics().figures();
  EXPECT_EQ(figures.vibration_peak_percent, 30.0);
  EXPECT_TRUE(figures.motors_on);
  EXPECT_EQ(figures.drive, protocol::DriveState::switch_on_disabled)
      << "the sensors' source never switches its motors on";
}

/// The halves of a combined touchpad answer on their own threads: not at once.
Result<device::TouchpadReadings> firstReadings(device::Touchpad& touchpad) {
  Result<device::TouchpadReadings> readings = fail("none yet");
  EXPECT_TRUE(comesTrue("the first readings", [&] {
    readings = touchpad.exchange({}, Clock::now());
    return readings && readings->ir.count > 0;
  }));
  return readings;
}

TEST(TouchpadProcess, ASilentMotorBoardIsComplainedOfWhileTheSensorsGoOn) {
  TouchpadProcessOptions options;
  options.modbus_tcp = *protocol::parseEndpoint("127.0.0.1:0");
  const auto process = *TouchpadProcess::start(options);
  auto touchpad = *device::withMotors(*device::openTouchpad(process->addresses().front(), quick()),
                                      "qbmove:" + scratch("none"), quick());
  const auto readings = firstReadings(*touchpad);
  ASSERT_TRUE(readings);
  EXPECT_EQ(readings->ir.value.size(), 3U);
  EXPECT_EQ(readings->motors.count, 0U);
  EXPECT_TRUE(comesTrue("a complaint of the motor board", [&] {
    return touchpad->complaint().text().find("plugged in") != std::string::npos;
  })) << touchpad->complaint().text();
}

/// Answers, and complains of warm motors.
class WarmTouchpad final : public device::Touchpad {
 public:
  [[nodiscard]] Message description() const override { return verbatim("warm"); }
  [[nodiscard]] Result<device::TouchpadReadings> exchange(const control::MotorCommand&, Instant now) override {
    readings_.ir.set({}, now);
    return readings_;
  }
  [[nodiscard]] Message complaint() const override { return verbatim("let them cool"); }
  [[nodiscard]] Duration period() const override { return std::chrono::milliseconds(1); }

 private:
  device::TouchpadReadings readings_;
};

TEST(TouchpadProcess, SensorsThatComplainGoOnWhileTheMotorBoardFails) {
  device::CombinedTouchpad touchpad(std::make_unique<WarmTouchpad>(),
                                    std::make_unique<device::QbmoveMotors>(scratch("none"), quick()), quick());
  const std::uint64_t before = firstReadings(touchpad)->ir.count;
  EXPECT_TRUE(comesTrue("further readings", [&] {
    const auto readings = touchpad.exchange({}, Clock::now());
    return readings && readings->ir.count > before;
  }));
  EXPECT_EQ(touchpad.complaint().text(), "let them cool");
}

/// Samples of the distance sensors that arrive in `seconds`.
std::uint64_t samplesIn(device::Touchpad& touchpad, double seconds) {
  const std::uint64_t before = firstReadings(touchpad)->ir.count;
  std::uint64_t count = before;
  for (const Instant end = Clock::now() + fromSeconds(seconds); Clock::now() < end;) {
    if (const auto readings = touchpad.exchange({}, Clock::now())) count = readings->ir.count;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return count - before;
}

TEST(TouchpadProcess, AMotorBoardThatIsSilentForItsLongestTimeOutDoesNotAgeTheSensors) {
  TouchpadProcessOptions options;
  options.modbus_tcp = *protocol::parseEndpoint("127.0.0.1:0");
  const auto process = *TouchpadProcess::start(options);
  const auto line = SerialEnd::open(scratch("mute"), 115'200);  // a port behind which nobody answers
  ASSERT_TRUE(line);
  device::DeviceParameters parameters = quick();
  parameters.qbmove_timeout_ms = 200.0;
  // Two seconds of a busy machine are not alike: one pair of five must be. A board that held the sensors up would leave
  // a tenth of their samples in each.
  double share = 0.0;
  for (int pair = 0; pair < 5 && share <= 0.6; ++pair) {
    auto alone = *device::openTouchpad(process->addresses().front(), parameters);
    const std::uint64_t healthy = samplesIn(*alone, 1.0);
    alone.reset();  // one master at a time
    auto touchpad = *device::withMotors(*device::openTouchpad(process->addresses().front(), parameters),
                                        "qbmove:" + scratch("mute"), parameters);
    const std::uint64_t beside_silence = samplesIn(*touchpad, 1.0);
    share = static_cast<double>(beside_silence) / static_cast<double>(healthy);
    EXPECT_TRUE(comesTrue("a complaint of the motor board", [&] {
      return touchpad->complaint().text().find("no answer to command") != std::string::npos;
    })) << touchpad->complaint().text();
  }
  RecordProperty("share_percent", static_cast<int>(100 * share));
  EXPECT_GT(share, 0.6);
}

TEST(TouchpadProcess, AMotorBoardIsSwitchedOffWhenItsTouchpadGoes) {
  TouchpadProcessOptions options;
  options.modbus_tcp = *protocol::parseEndpoint("127.0.0.1:0");
  options.qbmove = scratch("qbmove-off");
  const auto process = *TouchpadProcess::start(options);
  device::DeviceParameters parameters = quick();
  parameters.qbmove_watchdog_ms = 5000.0;  // not what switches it off here
  parameters.watchdog_ms = 1000.0;
  {
    auto touchpad = *device::withMotors(*device::openTouchpad(process->addresses().front(), parameters),
                                        "qbmove:" + options.qbmove, parameters);
    EXPECT_TRUE(comesTrue("motors that are on", [&] {
      (void)touchpad->exchange({.active = touchpad->complaint().empty()}, Clock::now());
      return process->electronics().figures().motors_on;
    })) << touchpad->complaint().text();
  }
  // Long before its own watchdog would have done it.
  EXPECT_TRUE(comesTrue(
      "motors that are off", [&] { return !process->electronics().figures().motors_on; }, std::chrono::seconds(4)));
}

TEST(TouchpadProcess, ASerialPortBelongsToOneProgramAtATime) {
  Rig rig(Line::rtu);
  ASSERT_TRUE(rig.exchange());
  ModbusTouchpad second(*device::parseModbusAddress(rig.address), quick());
  const Error in_use = second.exchange({}, Clock::now()).error();
  EXPECT_THAT(in_use.text(), HasSubstr("in use by another program"));
  EXPECT_TRUE(device::isInUse(in_use.message));
  rig.touchpad.reset();
  EXPECT_TRUE(second.exchange({}, Clock::now()));
}

// A serial line stays open while the touchpad behind it loses its supply.
TEST(TouchpadProcess, ATouchpadThatRestartsBehindItsAdapterIsIdentifiedAnew) {
  Rig rig(Line::rtu, quick());
  ASSERT_TRUE(rig.exchangeUntil("a clock that can go back", false,
                                [&] { return rig.touchpad->state().uptime_us > 1'500'000U; }));
  ASSERT_EQ(rig.touchpad->counters().connections, 1U);
  rig.process->inject(TouchpadFault::brown_out, 0.15);
  ASSERT_TRUE(
      rig.exchangeUntil("the restart to be seen", false, [&] { return rig.touchpad->counters().restarts == 1U; }));
  EXPECT_TRUE(
      rig.exchangeUntil("a new identification", false, [&] { return rig.touchpad->counters().connections == 2U; }));
  EXPECT_TRUE(comesTrue("a good exchange", [&] { return rig.exchange().has_value(); })) << rig.problem;
}

TEST(TouchpadProcess, TheStreamIsACameraAndFreezesOnDemand) {
  TouchpadProcessOptions options;
  options.camera_mjpeg = *protocol::parseEndpoint("127.0.0.1:0");
  options.parameters.camera_noise = 8.0;
  const auto process = *TouchpadProcess::start(options);
  auto camera = device::openCamera(process->addresses().front());
  ASSERT_TRUE(camera) << camera.error().text();
  cv::Mat before;
  int equal = 0;
  int different = 0;
  for (int i = 0; i < 150 && equal < 5; ++i) {
    if (different == 10) process->inject(TouchpadFault::camera_freeze, 600.0);
    const auto frame = (*camera)->next();
    ASSERT_TRUE(frame) << frame.error().text();
    ASSERT_EQ(frame->picture.size(), cv::Size(320, 240));
    const bool same = !before.empty() && cv::norm(before, frame->picture, cv::NORM_INF) == 0.0;
    equal = same ? equal + 1 : 0;
    different += same ? 0 : 1;
    before = frame->picture.clone();
  }
  EXPECT_EQ(equal, 5);
  EXPECT_GT(different, 5);
}

TEST(TouchpadProcess, ATakenPortAndNothingToServeAreNamed) {
  EXPECT_FALSE(TouchpadProcess::start({}));
  TouchpadProcessOptions options;
  options.modbus_tcp = *protocol::parseEndpoint("127.0.0.1:0");
  const auto first = *TouchpadProcess::start(options);
  options.modbus_tcp->port = first->modbusPort();
  EXPECT_THAT(TouchpadProcess::start(options).error().text(), HasSubstr("cannot listen"));
}

TEST(SerialEnd, TheLinkGoesWithItsTerminalAndADeadOneIsReplaced) {
  const std::string path = scratch("link");
  std::filesystem::create_symlink("/dev/pts/there-is-none", path);
  {
    const auto end = SerialEnd::open(path, 115'200);
    ASSERT_TRUE(end) << end.error().text();
    EXPECT_TRUE(std::filesystem::exists(path));
  }
  EXPECT_FALSE(std::filesystem::is_symlink(path));
}

}  // namespace
}  // namespace fyd::sim
