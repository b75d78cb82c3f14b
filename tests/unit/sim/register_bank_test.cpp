// The simulated touchpad's firmware in virtual time: watchdog, thermal limit, masters, batches, faults.
#include "core/sim/server/register_bank.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/sim/server/motor_board.h"
#include "core/sim/server/touchpad_electronics.h"
#include "tests/sweep.h"

namespace fyd::sim {
namespace {

using protocol::addressOf;
using protocol::DriveState;

constexpr int kMaster = 1;
constexpr std::array<std::uint16_t, 3> kSwitchingOn = {0x06, 0x07, 0x0F};
constexpr std::array<double, 2> kCool = {25.0, 25.0};

Instant at(double seconds) { return instantAt(100.0 + seconds); }

struct Bank {
  Bank() { bank.restart(at(0.0), protocol::DriveFault::none); }
  ModbusException write(std::string_view name, std::uint16_t value, double t, int master = kMaster) {
    for (const protocol::RegisterInfo& info : protocol::kRegisters) {
      if (info.name == name) return bank.write(master, info.address, {&value, 1}, at(t));
    }
    return ModbusException::illegal_function;
  }
  void enable(double t) {
    for (const std::uint16_t word : kSwitchingOn) EXPECT_EQ(write("control_word", word, t), ModbusException::none);
    beat(t);
  }
  void beat(double t) { EXPECT_EQ(write("heartbeat", ++heartbeat, t), ModbusException::none); }
  std::uint16_t read(std::uint16_t address, double t) {
    RegisterBank::Image image{};
    bank.fill(image, kMaster, readings, at(t));
    return image.at(address);
  }
  RegisterBank bank;
  device::TouchpadReadings readings;
  std::uint16_t heartbeat = 0;
};

TEST(RegisterBank, TheWatchdogSwitchesTheMotorsOffAndAReturningHeartbeatDoesNotSwitchThemOn) {
  Bank b;
  b.enable(0.0);
  b.bank.supervise(at(0.100), kCool);
  EXPECT_TRUE(b.bank.commandAt(at(0.100)).active);
  b.bank.supervise(at(0.102), kCool);
  EXPECT_FALSE(b.bank.commandAt(at(0.102)).active);
  EXPECT_EQ(b.bank.drive().fault(), protocol::DriveFault::heartbeat);
  EXPECT_NE(b.read(addressOf("status_word"), 0.103) & protocol::status_bit::kWatchdogExpired, 0);
  b.beat(0.11);
  EXPECT_EQ(b.write("control_word", 0x0F, 0.11), ModbusException::none);
  b.bank.supervise(at(0.112), kCool);
  EXPECT_FALSE(b.bank.commandAt(at(0.112)).active);
}

TEST(RegisterBank, WritingTheSameHeartbeatDoesNotWindTheWatchdogUp) {
  Bank b;
  b.enable(0.0);
  for (int i = 1; i <= 12; ++i) EXPECT_EQ(b.write("heartbeat", b.heartbeat, 0.01 * i), ModbusException::none);
  b.bank.supervise(at(0.12), kCool);
  EXPECT_EQ(b.bank.drive().state(), DriveState::fault);
}

TEST(RegisterBank, TooHotIsWarnedOfThenSwitchedOff) {
  Bank b;
  b.enable(0.0);
  b.bank.supervise(at(0.01), {60.0, 76.0});
  EXPECT_NE(b.read(addressOf("status_word"), 0.01) & protocol::status_bit::kWarning, 0);
  EXPECT_TRUE(b.bank.drive().energised());
  EXPECT_EQ(b.read(addressOf("temperature_2"), 0.01), 760);
  b.bank.supervise(at(0.02), {60.0, 85.0});
  EXPECT_EQ(b.read(addressOf("fault_code"), 0.02), 0x4310);
  EXPECT_FALSE(b.bank.drive().energised());
}

TEST(RegisterBank, OneMasterWritesAndAnotherTakesOverOnlyAfterItsSilenceOrEnd) {
  Bank b;
  b.beat(0.0);
  EXPECT_EQ(b.write("heartbeat", 77, 0.5, 2), ModbusException::busy);
  EXPECT_EQ(b.write("watchdog", 50, 0.5, 2), ModbusException::busy);
  EXPECT_EQ(b.bank.refusedWrites(), 2U);
  EXPECT_EQ(b.write("heartbeat", 78, 1.1, 2), ModbusException::none) << "a second of silence";
  EXPECT_EQ(b.write("heartbeat", 79, 1.2, kMaster), ModbusException::busy);
  b.bank.forget(2);
  EXPECT_EQ(b.write("heartbeat", 80, 1.3, kMaster), ModbusException::none);
}

TEST(RegisterBank, RefusesWhatIsOutOfRangeWithTheRightException) {
  Bank b;
  EXPECT_EQ(b.write("watchdog", 19, 0.0), ModbusException::illegal_value);
  EXPECT_EQ(b.write("watchdog", 20, 0.0), ModbusException::none);
  EXPECT_EQ(b.write("thermal_limit", 1251, 0.0), ModbusException::illegal_value);
  EXPECT_EQ(b.write("vibration_rate", 0, 0.0), ModbusException::illegal_value);
  EXPECT_EQ(b.write("vibration_count", 33, 0.0), ModbusException::illegal_value);
  EXPECT_EQ(b.write("ir_1", 5, 0.0), ModbusException::illegal_address);
  EXPECT_TRUE(RegisterBank::readable(protocol::kStateAddress, protocol::kStateRegisters));
  EXPECT_FALSE(RegisterBank::readable(protocol::kStateAddress, protocol::kStateRegisters + 1));
  EXPECT_FALSE(RegisterBank::readable(0, 0));
  EXPECT_FALSE(RegisterBank::readable(65'535, 2));
  EXPECT_FALSE(RegisterBank::readable(20, 1));
}

TEST(RegisterBank, ABatchIsPlayedAtItsRateThenHeldTenMillisecondsThenZero) {
  Bank b;
  b.enable(0.0);
  protocol::DeviceCommand command{.control_word = 0x0F, .heartbeat = 9};
  command.vibration_batch = 1;
  for (const std::int8_t duty : std::initializer_list<std::int8_t>{10, 20, 30})
    ASSERT_TRUE(command.duties.push({duty, static_cast<std::int8_t>(-duty)}));
  protocol::CommandRegisters registers{};
  const std::size_t count = protocol::encode(command, registers);
  ASSERT_EQ(b.bank.write(kMaster, protocol::kCommandAddress, {registers.data(), count}, at(0.010)),
            ModbusException::none);
  // The same batch once more, as a repeated request brings it: not played twice.
  ASSERT_EQ(b.bank.write(kMaster, protocol::kCommandAddress, {registers.data(), count}, at(0.011)),
            ModbusException::none);
  const auto duty = [&](double t) { return b.bank.commandAt(at(t)).vibration_duty_percent; };
  EXPECT_EQ(duty(0.0105)[0], 10.0);
  EXPECT_EQ(duty(0.0115)[1], -20.0);
  EXPECT_EQ(duty(0.0125)[0], 30.0);
  EXPECT_EQ(duty(0.0225)[0], 30.0);
  EXPECT_EQ(duty(0.0231)[0], 0.0);
}

TEST(RegisterBank, MoreDutiesThanCanBePlayedAreDroppedFromTheOldAndCounted) {
  VibrationQueue queue;
  std::vector<protocol::DutyPair> duties(32);
  for (int batch = 0; batch < 3; ++batch) {
    for (int i = 0; i < 32; ++i) duties[static_cast<std::size_t>(i)] = {static_cast<std::int8_t>(batch * 32 + i), 0};
    queue.push(duties, 1000.0, at(0.0));
  }
  EXPECT_EQ(queue.waiting(), 48U);
  EXPECT_EQ(queue.lost(), 48);
  EXPECT_EQ(queue.at(at(0.0))[0], 48);
}

TEST(RegisterBank, TheClockWrapsInADayAndNothingElseNotices) {
  Bank b;
  const double wrap_s = 4294.967296;
  EXPECT_EQ(b.read(addressOf("uptime"), wrap_s - 0.001), 0xFFFF);
  EXPECT_EQ(b.read(addressOf("uptime"), wrap_s + 0.001), 0);
  EXPECT_EQ(b.read(addressOf("uptime") + 1, wrap_s + 0.001), 1000);
  EXPECT_EQ(b.read(addressOf("uptime"), 86'400.0),
            static_cast<std::uint16_t>((86'400'000'000ULL & 0xFFFFFFFFULL) >> 16U));
}

TEST(RegisterBank, AnAnswerOfBeforeItsPowerUpSaysThatTheClockHasJustBegun) {
  Bank b;
  b.bank.restart(at(1.0), protocol::DriveFault::undervoltage);
  EXPECT_EQ(b.read(addressOf("uptime"), 0.999), 0);
  EXPECT_EQ(b.read(addressOf("uptime") + 1, 0.999), 0);
  EXPECT_EQ(b.read(addressOf("uptime") + 1, 1.001), 1000);
}

TEST(MotorBoard, ItsWatchdogExpiresAndItsVibrationCommandIsTheOneItWasGiven) {
  MotorBoard board({.vibration_opcode = 145});
  const auto tell = [&](const protocol::QbmoveFrame& frame, double t) {
    return board.handle(frame, {90.0, -90.0}, {11.0, -22.0}, at(t));
  };
  const std::array<std::int16_t, 2> values = {30, -30};
  (void)tell(protocol::qbmoveByteFrame(protocol::qbmove::kSetWatchdog, 5), 0.0);
  (void)tell(protocol::qbmoveByteFrame(protocol::qbmove::kActivate, 3), 0.0);
  (void)tell(protocol::qbmoveFrame(145, values), 0.01);
  (void)tell(protocol::qbmoveFrame(146, std::array<std::int16_t, 2>{99, 99}), 0.01);
  EXPECT_EQ(board.command().vibration_duty_percent[1], -30.0);
  const auto measured = tell(protocol::qbmoveFrame(protocol::qbmove::kGetMeasurements), 0.02);
  ASSERT_TRUE(measured);
  EXPECT_EQ(measured->at(0), 4200);
  EXPECT_EQ(measured->at(1), -4200);
  board.supervise(at(0.12));
  EXPECT_TRUE(board.command().active);
  board.supervise(at(0.121));
  EXPECT_FALSE(board.command().active);
}

TEST(TouchpadElectronics, ABrownOutRestartsItWithTheMotorsOff) {
  const FaultPlan faults({*parseTimedFault("brown-out@1")}, at(0.0));
  TouchpadElectronics electronics(
      std::make_shared<TouchpadWorld>(SimParameters{}, FingerPath::demonstration(), at(0.0)), faults, {}, at(0.0));
  const auto run = [&](double from, double to) {
    for (const double t : stepsBefore(from, to, 0.05)) electronics.advanceTo(at(t));
  };
  run(0.0, 0.9);
  for (const std::uint16_t word : kSwitchingOn) {
    EXPECT_EQ(electronics.write(1, addressOf("control_word"), {&word, 1}, at(0.9)), ModbusException::none);
  }
  const std::uint16_t heartbeat = 1;
  EXPECT_EQ(electronics.write(1, addressOf("heartbeat"), {&heartbeat, 1}, at(0.9)), ModbusException::none);
  electronics.advanceTo(at(0.99));
  EXPECT_TRUE(electronics.figures().motors_on);
  run(1.0, 1.6);
  EXPECT_FALSE(electronics.powered(at(1.2)));
  EXPECT_TRUE(electronics.powered(at(1.6)));
  EXPECT_FALSE(electronics.figures().motors_on);
  EXPECT_EQ(electronics.figures().fault, protocol::DriveFault::undervoltage);
  RegisterBank::Image image{};
  electronics.fill(image, 1, at(1.6));
  EXPECT_LT(image[addressOf("uptime")], 3) << "its clock began anew";
}

TEST(TouchpadElectronics, ALateReplyIsLateForItsTimeAndWithoutATimeOnce) {
  const auto with = [](const char* fault) {
    return std::make_unique<TouchpadElectronics>(
        std::make_shared<TouchpadWorld>(SimParameters{}, FingerPath::demonstration(), at(0.0)),
        FaultPlan({*parseTimedFault(fault)}, at(0.0)), MotorBoardOptions{}, at(0.0));
  };
  const auto unasked = with("late-reply@1+0.5");
  EXPECT_FALSE(unasked->answersLate(at(0.9)));
  EXPECT_FALSE(unasked->answersLate(at(3.0))) << "nobody asked while it lasted";
  const auto asked = with("late-reply@1+0.5");
  for (const double t : {1.0, 1.2, 1.4}) EXPECT_TRUE(asked->answersLate(at(t))) << t;
  EXPECT_FALSE(asked->answersLate(at(1.6)));
  const auto once = with("late-reply@1");
  EXPECT_FALSE(once->answersLate(at(0.9)));
  EXPECT_TRUE(once->answersLate(at(3.0))) << "the first that asks";
  EXPECT_FALSE(once->answersLate(at(3.1)));
}

TEST(TouchpadFault, ReadsTimesAndNamesWhatItExpected) {
  EXPECT_EQ(parseTimedFault("silence@2.5+1")->for_s, 1.0);
  EXPECT_EQ(parseTimedFault("late-reply@2")->for_s, 0.0);
  for (const char* wrong :
       {"silence", "silence@", "silence@x", "silence@1+", "noise@1", "@1", "silence@-1", "silence@nan"}) {
    EXPECT_THAT(parseTimedFault(wrong).error().text(), testing::HasSubstr("camera-freeze")) << wrong;
  }
}

}  // namespace
}  // namespace fyd::sim
