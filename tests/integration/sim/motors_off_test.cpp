// Motors that the console cannot reach go off by their own board's watchdog, whatever the board does meanwhile. The real
// drivers against the real servers; the firmware's clock is the test's.
#include <gtest/gtest.h>

#include <atomic>

#include "core/device/touchpad/modbus_touchpad.h"
#include "core/device/touchpad/qbmove_motors.h"
#include "core/protocol/endpoint.h"
#include "core/sim/finger_path.h"
#include "core/sim/server/modbus_server.h"
#include "core/sim/server/qbmove_server.h"
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
  EXPECT_LE(toMilliseconds(now() - stopped), parameters.watchdog_ms + 3.0 * toMilliseconds(kCycle));
}

}  // namespace
}  // namespace fyd::sim
