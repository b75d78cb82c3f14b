// Motors that the console cannot reach go off by their own board's watchdog, whatever the board does meanwhile. The real
// drivers against the real servers; the firmware's clock is the test's.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <span>
#include <thread>

#include <poll.h>
#include <unistd.h>

#include "core/device/touchpad/modbus_touchpad.h"
#include "core/device/touchpad/qbmove_motors.h"
#include "core/protocol/endpoint.h"
#include "core/sim/finger_path.h"
#include "core/sim/server/modbus_server.h"
#include "core/sim/server/qbmove_server.h"
#include "core/sim/server/serial_end.h"
#include "core/sim/server/touchpad_electronics.h"
#include "core/sim/touchpad/touchpad_world.h"
#include "tests/temporary_folder.h"

namespace fyd::sim {
namespace {

using std::chrono::milliseconds;

class MotorsOff : public testing::Test {
 protected:
  MotorsOff() { parameters.response_timeout_ms = parameters.qbmove_timeout_ms = 1000.0; }  // of this machine's time

  void begin(TouchpadFault fault, Duration after, double seconds) {
    FaultPlan faults({}, now());
    faults.add(fault, now() + after, seconds);
    electronics = std::make_shared<TouchpadElectronics>(
        std::make_shared<TouchpadWorld>(SimParameters{}, FingerPath::demonstration(), now()), faults,
        MotorBoardOptions{}, now());
    electronics->readTimeFrom([this] { return now(); });
  }
  [[nodiscard]] Instant now() const { return Instant(Duration(clock_ns.load())); }
  void pass(Duration time) {
    clock_ns += time.count();
    electronics->advanceTo(now());
  }
  [[nodiscard]] bool on() const { return electronics->figures().motors_on; }

  std::atomic<std::int64_t> clock_ns{1'000'000'000};
  std::shared_ptr<TouchpadElectronics> electronics;
  device::DeviceParameters parameters;
  Folder folder;
};

// A board that comes back without a watchdog says nothing of it in its answers.
TEST_F(MotorsOff, AMotorBoardThatRestartedGetsItsWatchdogBeforeItIsSwitchedOn) {
  begin(TouchpadFault::brown_out, milliseconds(200), 0.05);
  const auto server = QbmoveServer::start(folder.file("board"), 2'000'000, electronics);
  ASSERT_TRUE(server) << server.error().text();
  device::QbmoveMotors motors(folder.file("board"), parameters);
  ASSERT_TRUE(motors.exchange({}));
  pass(milliseconds(400));  // no frame is lost: the console does not notice
  ASSERT_EQ(electronics->figures().restarts, 1U);
  ASSERT_TRUE(motors.exchange({.active = true}));
  pass(milliseconds(2));
  ASSERT_TRUE(on());
  pass(fromSeconds(1e-3 * parameters.qbmove_watchdog_ms) + milliseconds(40));  // the board counts in steps of 20 ms
  EXPECT_FALSE(on());
}

// A board without a watchdog at the end of a line that loses what the test says.
class BoardOnABadLine {
 public:
  /// @param path of the line's end, as a motor board's
  explicit BoardOnABadLine(const std::string& path) : line_(PseudoTerminal::open(path).value()) {
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }
  std::atomic<bool> on{false};
  std::atomic<int> offs_lost{0};    // so many of the next frames that switch off do not arrive
  std::atomic<bool> silent{false};  // no answer arrives

 private:
  void run(const std::stop_token& stop) {
    protocol::QbmoveParser parser;
    std::array<std::uint8_t, 256> buffer{};
    while (!stop.stop_requested()) {
      pollfd ready{.fd = line_.file(), .events = POLLIN, .revents = 0};
      if (::poll(&ready, 1, 10) <= 0) continue;
      const ssize_t got = ::read(line_.file(), buffer.data(), buffer.size());
      for (ssize_t i = 0; i < got; ++i) {
        if (const auto frame = parser.push(buffer[static_cast<std::size_t>(i)])) take(*frame);
      }
    }
  }
  void take(const protocol::QbmoveFrame& frame) {
    namespace qb = protocol::qbmove;
    const std::array<std::int16_t, 3> zeros{};
    switch (frame.command) {
      case qb::kActivate:
        if (frame.payload[0] == 0 && offs_lost > 0) {
          --offs_lost;
        } else {
          on = frame.payload[0] != 0;
        }
        break;
      case qb::kGetActivate: answer(protocol::qbmoveByteFrame(frame.command, on ? 3 : 0)); break;
      case qb::kGetMeasurements: answer(protocol::qbmoveFrame(frame.command, zeros)); break;
      case qb::kGetCurrents: answer(protocol::qbmoveFrame(frame.command, std::span(zeros).first(2))); break;
      case qb::kPing: answer(protocol::qbmoveFrame(frame.command)); break;
      default: break;
    }
  }
  void answer(const protocol::QbmoveFrame& frame) {
    if (silent) return;
    const protocol::QbmoveBytes bytes = protocol::encode(frame);
    const auto view = bytes.view();
    ASSERT_EQ(::write(line_.file(), view.data(), view.size()), static_cast<ssize_t>(view.size()));
  }

  PseudoTerminal line_;
  std::jthread thread_;
};

TEST_F(MotorsOff, AMotorBoardIsToldAgainUntilItSaysThatItIsOff) {
  BoardOnABadLine board(folder.file("board"));
  device::QbmoveMotors motors(folder.file("board"), parameters);
  ASSERT_TRUE(motors.exchange({}));
  ASSERT_TRUE(motors.exchange({.active = true}));
  ASSERT_TRUE(board.on);
  board.offs_lost = 2;
  for (int i = 0; i < 2; ++i) {
    const auto told = motors.exchange({});
    ASSERT_FALSE(told) << "it is on, and said to be well";
    EXPECT_THAT(told.error().text(), testing::HasSubstr("does not obey: its motors are on"));
  }
  EXPECT_TRUE(motors.exchange({}));
  EXPECT_FALSE(board.on);
}

TEST_F(MotorsOff, AMotorBoardThatIsHeardNoMoreIsSwitchedOffAllTheSame) {
  parameters.qbmove_timeout_ms = 20.0;
  BoardOnABadLine board(folder.file("board"));
  device::QbmoveMotors motors(folder.file("board"), parameters);
  for (int i = 0; i < 50 && !motors.exchange({}); ++i) continue;  // a slow machine's answers come late
  for (int i = 0; i < 50 && !board.on; ++i) {
    (void)motors.exchange({});
    (void)motors.exchange({.active = true});
  }
  ASSERT_TRUE(board.on);
  board.silent = true;
  board.offs_lost = 1;
  for (int i = 0; i < 8 && board.on; ++i) EXPECT_FALSE(motors.exchange({.active = true}));
  EXPECT_FALSE(board.on);
}

TEST_F(MotorsOff, WhyAMotorBoardIsOffIsKnownUntilItIsSwitchedOnAgain) {
  BoardOnABadLine board(folder.file("board"));
  device::QbmoveMotors motors(folder.file("board"), parameters);
  ASSERT_TRUE(motors.exchange({}));
  ASSERT_TRUE(motors.exchange({.active = true}));
  ASSERT_TRUE(board.on);
  board.on = false;  // by itself
  Result<control::MotorFeedback> moved = control::MotorFeedback{};
  for (int i = 0; i < 100 && moved; ++i) moved = motors.exchange({.active = true});
  ASSERT_FALSE(moved);
  EXPECT_EQ(moved.error().text(), motors.whySwitchedOff().text());
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(motors.exchange({})) << "its readings are back at once";
  EXPECT_THAT(motors.whySwitchedOff().text(), testing::HasSubstr("by itself: mend that, then arm again"));
  ASSERT_TRUE(motors.exchange({.active = true}));
  EXPECT_TRUE(board.on);
  EXPECT_EQ(motors.whySwitchedOff().text(), "");
}

// Its giver stood still, or waited for other devices that fail.
TEST_F(MotorsOff, AMotorBoardWhoseCommandWasNotRenewedIsSwitchedOnByTheNextArmOnly) {
  BoardOnABadLine board(folder.file("board"));
  device::QbmoveMotors motors(folder.file("board"), parameters);
  ASSERT_TRUE(motors.exchange({}, false));
  ASSERT_TRUE(motors.exchange({.active = true}));
  ASSERT_TRUE(board.on);
  EXPECT_FALSE(motors.exchange({.active = true}, false));
  EXPECT_FALSE(board.on);
  for (int i = 0; i < 5; ++i) {
    const auto moved = motors.exchange({.active = true});
    ASSERT_FALSE(moved);
    EXPECT_THAT(moved.error().text(), testing::HasSubstr("not renewed in time: mend that, then arm again"));
    EXPECT_FALSE(board.on);
  }
  EXPECT_TRUE(motors.exchange({}));
  ASSERT_TRUE(motors.exchange({.active = true}));
  EXPECT_TRUE(board.on);
}

TEST_F(MotorsOff, WhatAMotorBoardWasRefusedForIsNotForgottenWhenItsCommandIsNotRenewed) {
  BoardOnABadLine board(folder.file("board"));
  device::QbmoveMotors motors(folder.file("board"), parameters);
  ASSERT_TRUE(motors.exchange({}));
  ASSERT_TRUE(motors.exchange({.active = true}));
  board.on = false;  // by itself
  Result<control::MotorFeedback> moved = control::MotorFeedback{};
  for (int i = 0; i < 100 && moved; ++i) moved = motors.exchange({.active = true});
  ASSERT_FALSE(moved);
  EXPECT_FALSE(motors.exchange({.active = true}, false));
  EXPECT_FALSE(motors.exchange({.active = true}));
  EXPECT_FALSE(board.on);
  EXPECT_THAT(motors.whySwitchedOff().text(), testing::HasSubstr("by itself"));
}

TEST_F(MotorsOff, ATouchpadThatDoesNotObeyOffIsSwitchedOffByItsWatchdog) {
  constexpr Duration kCycle = milliseconds(4);
  constexpr Duration kBegins = milliseconds(400);
  begin(TouchpadFault::disobedience, kBegins, 60.0);
  const auto server = ModbusTcpServer::start(*protocol::parseEndpoint("127.0.0.1:0"), electronics);
  ASSERT_TRUE(server) << server.error().text();
  device::ModbusTouchpad touchpad(
      *device::parseModbusAddress(fmt::format("modbus-tcp:127.0.0.1:{}", (*server)->local().port)), parameters);
  const Instant start = now();
  while (now() - start < kBegins) {
    ASSERT_TRUE(touchpad.exchange({.active = true}, now()));
    pass(kCycle);
  }
  ASSERT_TRUE(on());
  const Instant stopped = now();
  while (on() && now() - stopped < milliseconds(1000)) {
    ASSERT_TRUE(touchpad.exchange({}, now()));  // it answers, and does nothing
    pass(kCycle);
  }
  const double after_ms = toMilliseconds(now() - stopped);
  EXPECT_GE(after_ms, parameters.watchdog_ms - 2.0 * toMilliseconds(kCycle)) << "not by its watchdog";
  EXPECT_LE(after_ms, parameters.watchdog_ms + 3.0 * toMilliseconds(kCycle));
}

}  // namespace
}  // namespace fyd::sim
