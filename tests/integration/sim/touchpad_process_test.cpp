// The real drivers against the simulator's servers: TCP sockets and pseudo-terminals, with every fault.
#include "core/sim/touchpad_process.h"

#include <filesystem>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <opencv2/core.hpp>

#include "core/device/camera_source.h"
#include "core/device/combined_touchpad.h"
#include "core/device/modbus_touchpad.h"
#include "core/device/touchpad_source.h"

namespace fyd::sim {
namespace {

using device::ModbusTouchpad;
using testing::HasSubstr;

enum class Line : std::uint8_t { tcp, rtu };

device::DeviceParameters quick() {
  device::DeviceParameters parameters;
  parameters.response_timeout_ms = 80.0;
  parameters.qbmove_timeout_ms = 30.0;  // a loaded test machine
  return parameters;
}

std::string scratch(const char* name) { return fmt::format("{}fyd-{}-{}", testing::TempDir(), name, ::getpid()); }

struct Rig {
  explicit Rig(Line line, std::vector<std::string> faults = {}) {
    TouchpadProcessOptions options;
    for (const std::string& text : faults) options.faults.push_back(*parseTimedFault(text));
    if (line == Line::tcp)
      options.modbus_tcp = *protocol::parseEndpoint("127.0.0.1:0");
    else
      options.modbus_rtu = scratch("rtu");
    process = std::move(*TouchpadProcess::start(std::move(options)));
    address = process->addresses().front();
    touchpad = std::make_unique<ModbusTouchpad>(*device::parseModbusAddress(address), quick());
  }
  Result<device::TouchpadReadings> exchange(bool active = false) {
    return touchpad->exchange({.reference_ticks = {2000, -2000}, .active = active}, Clock::now());
  }
  /// Exchanges every 4 ms. @return how many failed
  int run(double seconds, bool active = false) {
    int failed = 0;
    for (const Instant end = Clock::now() + fromSeconds(seconds); Clock::now() < end;) {
      const auto done = exchange(active);
      if (!done) {
        ++failed;
        problem = done.error().message;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(4));
    }
    return failed;
  }
  std::unique_ptr<TouchpadProcess> process;
  std::string address;
  std::unique_ptr<ModbusTouchpad> touchpad;
  std::string problem;
};

class BothLines : public testing::TestWithParam<Line> {};
INSTANTIATE_TEST_SUITE_P(Lines, BothLines, testing::Values(Line::tcp, Line::rtu),
                         [](const auto& line) { return line.param == Line::tcp ? "tcp" : "rtu"; });

TEST_P(BothLines, TheMotorsFollowAndTheSensorsTell) {
  Rig rig(GetParam());
  EXPECT_EQ(rig.run(0.4, true), 0);
  const auto readings = rig.exchange(true);
  ASSERT_TRUE(readings) << readings.error().message;
  const double target_deg = 2000 / control::kTicksPerDegree;
  EXPECT_NEAR(readings->motors.value.encoder_counts[0] / control::kEncoderCountsPerDegree, target_deg, 8.0);
  EXPECT_EQ(readings->ir.value.size(), 3U);
  EXPECT_GT(readings->ir.count, 5U);
  EXPECT_GT(readings->bridge.count, 10U);
  EXPECT_LT(toMilliseconds(Clock::now() - readings->ir.taken), 200.0);
  EXPECT_TRUE(rig.process->electronics().figures().motors_on);
}

TEST_P(BothLines, ALateReplyIsNeverTakenForAFreshOne) {
  Rig rig(GetParam(), {"late-reply@0.1"});
  const int failed = rig.run(0.8);
  EXPECT_GT(failed, 0) << "the late one at least";
  EXPECT_LT(failed, 40);
  EXPECT_TRUE(rig.exchange()) << "and then it goes on: " << rig.problem;
  // What is taken after the trap belongs to its own question: the uptime is today's.
  const std::uint32_t uptime_us = rig.touchpad->state().uptime_us;
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  ASSERT_TRUE(rig.exchange());
  EXPECT_GE(rig.touchpad->state().uptime_us - uptime_us, 49'000U);
}

TEST_P(BothLines, SilenceSwitchesTheMotorsOffAtTheDeviceAndTheyStayOff) {
  Rig rig(GetParam(), {"silence@0.3+0.25"});
  EXPECT_EQ(rig.run(0.2, true), 0);
  EXPECT_TRUE(rig.process->electronics().figures().motors_on);
  EXPECT_GT(rig.run(0.6, true), 0);
  EXPECT_FALSE(rig.process->electronics().figures().motors_on);
  EXPECT_THAT(rig.touchpad->complaint(), HasSubstr("stop, then arm again"));
  EXPECT_EQ(rig.run(0.1, false), 0);
  EXPECT_EQ(rig.run(0.2, true), 0);
  EXPECT_TRUE(rig.process->electronics().figures().motors_on);
}

TEST_P(BothLines, GarbageIsRefusedAndTheEndOfItHeals) {
  Rig rig(GetParam(), {"garbage@0.1+0.2"});
  EXPECT_GT(rig.run(0.5), 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(rig.run(0.1), 0) << rig.problem;
}

TEST_P(BothLines, ABrownOutIsComplainedOf) {
  Rig rig(GetParam(), {"brown-out@0.25+0.15"});
  EXPECT_EQ(rig.run(0.2, true), 0);
  EXPECT_GT(rig.run(0.6, true), 0);
  EXPECT_THAT(rig.touchpad->complaint(), HasSubstr("arm again"));
  EXPECT_FALSE(rig.process->electronics().figures().motors_on);
}

TEST_P(BothLines, AStuckSensorAndAJumpingEncoderShowWhatTheySay) {
  Rig rig(GetParam());
  ASSERT_TRUE(rig.exchange());
  const int before = rig.touchpad->state().motors.encoder_counts[0];
  rig.process->inject(TouchpadFault::stuck_sensor, 60.0);
  rig.process->inject(TouchpadFault::encoder_jump, 60.0);
  rig.run(0.2);
  const std::uint16_t stuck = rig.touchpad->state().ir[0];
  const std::uint16_t count = rig.touchpad->state().ir_count;
  rig.run(0.1);
  EXPECT_EQ(rig.touchpad->state().ir[0], stuck);
  EXPECT_NE(rig.touchpad->state().ir_count, count) << "its samples go on being counted";
  EXPECT_NEAR((rig.touchpad->state().motors.encoder_counts[0] - before + 4096) % 4096, 512, 2);
}

TEST_P(BothLines, BatchesOfDutiesArrive) {
  Rig rig(GetParam());
  rig.run(0.1, true);
  for (int i = 0; i < 20; ++i) {
    const std::array<device::VibrationDuty, 5> duties = {{{0, 0}, {20, 20}, {40, -40}, {60, 60}, {0, 0}}};
    rig.touchpad->queueVibration(duties);
    ASSERT_TRUE(rig.exchange(true));
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_EQ(rig.process->electronics().figures().vibration_peak_percent, 60.0);
}

TEST(TouchpadProcess, ASecondMasterIsRefusedWithAReasonAndTheFirstNotices) {
  Rig rig(Line::tcp);
  ASSERT_TRUE(rig.exchange());
  ModbusTouchpad second(*device::parseModbusAddress(rig.address), quick());
  const auto refused = second.exchange({}, Clock::now());
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("another program drives its motors"));
  EXPECT_TRUE(rig.exchange());
  EXPECT_GE(rig.process->electronics().figures().refused_writes, 1U);
}

TEST(TouchpadProcess, ComesBackEachTimeTheServerIsKilledInTheMiddle) {
  TouchpadProcessOptions options;
  options.modbus_tcp = *protocol::parseEndpoint("127.0.0.1:0");
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
    ASSERT_TRUE(next) << next.error().message;
    process = std::move(*next);
    bool back = false;
    for (int attempt = 0; attempt < 20 && !back; ++attempt) back = touchpad.exchange({}, Clock::now()).has_value();
    ASSERT_TRUE(back) << kill;
  }
}

TEST(TouchpadProcess, TheMotorBoardTakesTheMotorsAndTheSensorsStayOnModbus) {
  TouchpadProcessOptions options;
  options.modbus_tcp = *protocol::parseEndpoint("127.0.0.1:0");
  options.qbmove = scratch("qbmove");
  options.board.vibration_opcode = 145;
  const auto process = *TouchpadProcess::start(options);
  device::DeviceParameters parameters = quick();
  parameters.qbmove_vibration_opcode = 145;
  auto sensors = device::openTouchpad(process->addresses().front(), parameters);
  auto touchpad = *device::withMotors(std::move(*sensors), "qbmove:" + options.qbmove, parameters);
  Result<device::TouchpadReadings> readings = fail("none yet");
  for (const Instant end = Clock::now() + std::chrono::milliseconds(500); Clock::now() < end;) {
    readings = touchpad->exchange(
        {.reference_ticks = {2000, -2000}, .vibration_duty_percent = {30, 30}, .active = true}, Clock::now());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_TRUE(readings) << readings.error().message;
  EXPECT_EQ(touchpad->complaint(), "");
  EXPECT_NEAR(readings->motors.value.encoder_counts[0] / control::kEncoderCountsPerDegree,
              2000 / control::kTicksPerDegree, 8.0);
  EXPECT_GT(readings->ir.count, 5U);
  const auto figures = process->electronics().figures();
  EXPECT_EQ(figures.vibration_peak_percent, 30.0);
  EXPECT_TRUE(figures.motors_on);
  EXPECT_EQ(figures.drive, protocol::DriveState::switch_on_disabled)
      << "the sensors' source never switches its motors on";
}

/// The halves of a combined touchpad answer on their own threads: not at once.
Result<device::TouchpadReadings> firstReadings(device::Touchpad& touchpad) {
  Result<device::TouchpadReadings> readings = fail("none yet");
  for (int i = 0; i < 5000 && !(readings && readings->ir.count > 0); ++i) {
    readings = touchpad.exchange({}, Clock::now());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
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
  const auto named = [&] { return touchpad->complaint().find("plugged in") != std::string::npos; };
  for (int i = 0; i < 5000 && !named(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_THAT(touchpad->complaint(), HasSubstr("plugged in"));
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
  auto alone = *device::openTouchpad(process->addresses().front(), parameters);
  const std::uint64_t healthy = samplesIn(*alone, 1.0);
  alone.reset();  // one master at a time
  parameters.qbmove_timeout_ms = 200.0;
  auto touchpad = *device::withMotors(*device::openTouchpad(process->addresses().front(), parameters),
                                      "qbmove:" + scratch("mute"), parameters);
  const std::uint64_t beside_silence = samplesIn(*touchpad, 1.0);
  RecordProperty("healthy", static_cast<int>(healthy));
  RecordProperty("beside_silence", static_cast<int>(beside_silence));
  EXPECT_GT(static_cast<double>(beside_silence), 0.6 * static_cast<double>(healthy));
  EXPECT_THAT(touchpad->complaint(), HasSubstr("no answer to command"));
}

TEST(TouchpadProcess, AMotorBoardIsSwitchedOffWhenItsTouchpadGoes) {
  TouchpadProcessOptions options;
  options.modbus_tcp = *protocol::parseEndpoint("127.0.0.1:0");
  options.qbmove = scratch("qbmove-off");
  const auto process = *TouchpadProcess::start(options);
  device::DeviceParameters parameters = quick();
  parameters.qbmove_watchdog_ms = 5000.0;  // not what switches it off here
  {
    auto touchpad = *device::withMotors(*device::openTouchpad(process->addresses().front(), parameters),
                                        "qbmove:" + options.qbmove, parameters);
    for (int i = 0; i < 2000 && !process->electronics().figures().motors_on; ++i) {
      (void)touchpad->exchange({.active = true}, Clock::now());
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_TRUE(process->electronics().figures().motors_on);
  }
  for (int i = 0; i < 500 && process->electronics().figures().motors_on; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_FALSE(process->electronics().figures().motors_on);
}

TEST(TouchpadProcess, ASerialPortBelongsToOneProgramAtATime) {
  Rig rig(Line::rtu);
  ASSERT_TRUE(rig.exchange());
  ModbusTouchpad second(*device::parseModbusAddress(rig.address), quick());
  EXPECT_THAT(second.exchange({}, Clock::now()).error().message, HasSubstr("in use by another program"));
  rig.touchpad.reset();
  EXPECT_TRUE(second.exchange({}, Clock::now()));
}

TEST(TouchpadProcess, TheStreamIsACameraAndFreezesOnDemand) {
  TouchpadProcessOptions options;
  options.camera_mjpeg = *protocol::parseEndpoint("127.0.0.1:0");
  options.parameters.camera_noise = 8.0;
  options.faults = {*parseTimedFault("camera-freeze@1.5")};
  const auto process = *TouchpadProcess::start(options);
  auto camera = device::openCamera(process->addresses().front());
  ASSERT_TRUE(camera) << camera.error().message;
  cv::Mat before;
  int equal = 0;
  int different = 0;
  for (int i = 0; i < 150 && equal < 5; ++i) {
    const auto frame = (*camera)->next();
    ASSERT_TRUE(frame) << frame.error().message;
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
  EXPECT_THAT(TouchpadProcess::start(options).error().message, HasSubstr("cannot listen"));
}

TEST(SerialEnd, TheLinkGoesWithItsTerminalAndADeadOneIsReplaced) {
  const std::string path = scratch("link");
  std::filesystem::create_symlink("/dev/pts/there-is-none", path);
  {
    const auto end = SerialEnd::open(path, 115'200);
    ASSERT_TRUE(end) << end.error().message;
    EXPECT_TRUE(std::filesystem::exists(path));
  }
  EXPECT_FALSE(std::filesystem::is_symlink(path));
}

}  // namespace
}  // namespace fyd::sim
