// The Modbus client against a device that misbehaves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/device/touchpad/modbus_touchpad.h"
#include "tests/integration/device/scripted_modbus_device.h"

namespace fyd::device {
namespace {

using testing::HasSubstr;

constexpr auto kGood = [](ScriptedModbusDevice&, int) { return 0; };

/// Patient with a machine that stands still.
DeviceParameters waiting(double response_timeout_ms = 2000.0) {
  DeviceParameters parameters;
  parameters.response_timeout_ms = response_timeout_ms;
  return parameters;
}

struct Client {
  explicit Client(const ScriptedModbusDevice& device, const DeviceParameters& parameters = waiting())
      : touchpad(*parseModbusAddress(device.address()), parameters) {}
  Result<TouchpadReadings> operator()(bool active = false) {
    return touchpad.exchange({.reference_ticks = {4200, -4200}, .active = active}, Clock::now());
  }
  ModbusTouchpad touchpad;
};

TEST(ModbusTouchpad, ReadsAHealthyDevice) {
  ScriptedModbusDevice device(kGood);
  device.state.ir = {1000, 2000, 3000};
  device.state.ir_age_ms = 7.0;
  device.state.bridge_mV_per_V = 0.25F;
  Client ask(device);
  const Instant before = Clock::now();
  const auto readings = ask();
  ASSERT_TRUE(readings) << readings.error().text();
  EXPECT_EQ(readings->ir.value[1], 2000);
  EXPECT_EQ(readings->bridge.value.value_mV_per_V, 0.25);
  // Seven milliseconds before it answered, which was after `before` and is over.
  EXPECT_GE(readings->ir.taken, before - std::chrono::milliseconds(7));
  EXPECT_LE(readings->ir.taken, Clock::now() - std::chrono::milliseconds(7));
  EXPECT_THAT(ask.touchpad.description().text(), HasSubstr("SCRIPTED"));
}

TEST(ModbusTouchpad, WrongMagicVersionAndOutfitAreNamed) {
  ScriptedModbusDevice device(kGood);
  device.identity.magic = 0xDEADBEEF;
  Client ask(device);
  EXPECT_THAT(ask().error().text(), HasSubstr("0xDEADBEEF"));
  device.identity.magic = protocol::kMapMagic;
  device.identity.map_version = 0x0203;
  EXPECT_THAT(ask().error().text(), HasSubstr("register map 2.3"));
  device.identity.map_version = 0x0109;
  EXPECT_TRUE(ask()) << "a newer minor version is read";
}

TEST(ModbusTouchpad, AnOutfitItDoesNotKnowIsNamed) {
  ScriptedModbusDevice device(kGood);
  device.identity.ir_sensors = 5;
  Client ask(device);
  EXPECT_THAT(ask().error().text(), HasSubstr("5 IR sensors"));
}

TEST(ModbusTouchpad, AnotherTouchpadInItsPlaceIsRefused) {
  ScriptedModbusDevice device([](ScriptedModbusDevice&, int n) { return n == 2 ? ScriptedModbusDevice::kClose : 0; });
  Client ask(device);
  ASSERT_TRUE(ask());
  device.identity.setSerial("OTHER");
  ASSERT_FALSE(ask());
  EXPECT_THAT(ask().error().text(), HasSubstr("another touchpad answers: 'OTHER', expected 'SCRIPTED'"));
  device.identity.setSerial("SCRIPTED");
  EXPECT_TRUE(ask());
}

TEST(ModbusTouchpad, TheConfiguredSerialNumberIsCheckedFromTheStart) {
  ScriptedModbusDevice device(kGood);
  ModbusTouchpad wrong(*parseModbusAddress(device.address() + ",serial=FYD-7"), waiting());
  EXPECT_THAT(wrong.exchange({}, Clock::now()).error().text(), HasSubstr("expected 'FYD-7'"));
  ModbusTouchpad right(*parseModbusAddress(device.address() + ",serial=SCRIPTED"), waiting());
  EXPECT_TRUE(right.exchange({}, Clock::now()));
}

// As behind an adapter that stays plugged in: the connection goes on, the clock is another one.
TEST(ModbusTouchpad, AnotherTouchpadOnAnOpenConnectionIsRefusedBeforeItsReadingsAreTaken) {
  ScriptedModbusDevice device([](ScriptedModbusDevice& d, int n) {
    if (n == 2) {
      d.identity.setSerial("OTHER");
      d.state.uptime_us += 100'000'000;
    }
    return 0;
  });
  Client ask(device);
  ASSERT_TRUE(ask());
  const auto changed = ask();
  ASSERT_FALSE(changed);
  EXPECT_THAT(changed.error().text(), HasSubstr("the touchpad restarted"));
  const auto other = ask();
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().text(), HasSubstr("another touchpad answers: 'OTHER', expected 'SCRIPTED'"));
}

TEST(ModbusTouchpad, OneThatRestartedOnAnOpenConnectionGetsItsSettingsAgainAndStaysOff) {
  constexpr int kRestart = 9;
  ScriptedModbusDevice device([](ScriptedModbusDevice& d, int n) {
    if (n == kRestart) {
      d.drive = {};
      d.state.status_word = statusBits(d.drive.state()) | protocol::status_bit::kRemote;
      d.state.uptime_us += 100'000'000;
      d.registers()[protocol::kSettingsAddress] = 0;
    }
    return 0;
  });
  Client ask(device);
  for (int i = 1; i < kRestart; ++i) ASSERT_TRUE(ask(true));
  ASSERT_FALSE(ask(true));
  EXPECT_EQ(device.registers()[protocol::kSettingsAddress], 0);
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(ask(true));
  EXPECT_EQ(device.registers()[protocol::kSettingsAddress], DeviceParameters{}.watchdog_ms);
  EXPECT_EQ(ask.touchpad.counters().connections, 2U);
  EXPECT_EQ(ask.touchpad.counters().restarts, 1U);
  EXPECT_NE(device.drive.state(), protocol::DriveState::operation_enabled);
  EXPECT_THAT(ask.touchpad.complaint().text(), HasSubstr("the touchpad restarted: mend that, then arm again"));
}

TEST(ModbusTouchpad, TheDevicesClockMayWrapWithoutARestart) {
  ScriptedModbusDevice device([](ScriptedModbusDevice& d, int n) {
    d.state.uptime_us = n == 1 ? 0xFFFFFF00U : 0x00000400U;
    return 0;
  });
  Client ask(device);
  ASSERT_TRUE(ask());
  ASSERT_TRUE(ask());
  EXPECT_EQ(ask.touchpad.counters().restarts, 0U);
}

TEST(ModbusTouchpad, ValuesOutOfTheirRangeAreRefused) {
  ScriptedModbusDevice device([](ScriptedModbusDevice& d, int n) {
    d.state.ir[1] = n == 2 ? 4096 : 1000;
    d.state.motors.encoder_counts[0] = n == 3 ? 4096 : 5;
    return 0;
  });
  Client ask(device);
  ASSERT_TRUE(ask());
  EXPECT_FALSE(ask());
  EXPECT_FALSE(ask());
  EXPECT_TRUE(ask());
}

TEST(ModbusTouchpad, ATemperatureThatNoMotorHasIsRefusedWithItsValue) {
  ScriptedModbusDevice device([](ScriptedModbusDevice& d, int n) {
    d.state.temperature_degC[0] = n == 2 ? 3276.7 : 30.0;
    return 0;
  });
  Client ask(device);
  ASSERT_TRUE(ask());
  EXPECT_THAT(ask().error().text(), HasSubstr("motor temperatures 3276.7, 0.0 °C, expected -40 to 200"));
  EXPECT_TRUE(ask());
}

TEST(ModbusTouchpad, ADeviceThatDoesNotObeyIsNeverDrivenAndItsMotorsAreWithheld) {
  bool obeys = true;
  ScriptedModbusDevice device([&](ScriptedModbusDevice& d, int) {
    if (!obeys) d.state.status_word &= static_cast<std::uint16_t>(~protocol::status_bit::kRemote);
    return 0;
  });
  Client ask(device);
  for (int i = 0; i < 8; ++i) ASSERT_TRUE(ask(true));
  ASSERT_EQ(device.drive.state(), protocol::DriveState::operation_enabled);
  const std::uint64_t before = ask(true)->motors.count;
  obeys = false;
  EXPECT_EQ(ask(true)->motors.count, before);
  EXPECT_THAT(ask.touchpad.complaint().text(), HasSubstr("does not obey"));
  obeys = true;
  for (int i = 0; i < 20; ++i) EXPECT_EQ(ask(true)->motors.count, before) << "until the command has been inactive";
  EXPECT_NE(device.drive.state(), protocol::DriveState::operation_enabled);
  EXPECT_GT(ask(false)->motors.count, before);
  EXPECT_EQ(ask.touchpad.complaint().text(), "");
  obeys = false;  // while the motors are off: not ready, and said
  const std::uint64_t idle = ask(false)->motors.count;
  EXPECT_EQ(ask(false)->motors.count, idle);
  EXPECT_THAT(ask.touchpad.complaint().text(), HasSubstr("set it to remote"));
}

TEST(ModbusTouchpad, ASetOfValuesThatStandsStillMakesTheMotorsOldThoughEveryAnswerIsFresh) {
  for (const bool clock : {true, false}) {
    bool frozen = false;
    protocol::DeviceState held;
    ScriptedModbusDevice device([&](ScriptedModbusDevice& d, int) {
      if (!frozen) held = d.state;
      if (clock) d.state.uptime_us = held.uptime_us;
      if (!clock) d.state.sequence = held.sequence;
      return 0;
    });
    Client ask(device);
    ASSERT_TRUE(ask());
    const std::uint64_t before = ask()->motors.count;
    EXPECT_GT(before, 1U);
    frozen = true;
    Instant now = Clock::now();
    for (int i = 0; i < 100; ++i) {
      const auto readings = ask.touchpad.exchange({}, now += std::chrono::milliseconds(4));
      ASSERT_TRUE(readings);
      ASSERT_EQ(readings->motors.count, before);
      ASSERT_EQ(readings->ir.taken, now) << "what has a count of its own goes by that";
    }
    EXPECT_THAT(ask.touchpad.complaint().text(), HasSubstr("stands still"));
    frozen = false;
    EXPECT_GT(ask()->motors.count, before);
    EXPECT_EQ(ask.touchpad.complaint().text(), "");
  }
}

TEST(ModbusTouchpad, EveryExceptionIsNamedAndTheNextCycleGoesOn) {
  const std::vector<std::pair<int, std::string>> kExceptions = {{1, "exception 1"},     {2, "exception 2"},
                                                                {3, "exception 3"},     {4, "exception 4"},
                                                                {6, "another program"}, {11, "gateway"}};
  for (const auto& [code, text] : kExceptions) {
    ScriptedModbusDevice device([code = code](ScriptedModbusDevice&, int n) { return n == 2 ? code : 0; });
    Client ask(device);
    ASSERT_TRUE(ask());
    const auto refused = ask();
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text(), HasSubstr(text));
    EXPECT_TRUE(ask());
    EXPECT_EQ(ask.touchpad.counters().connections, 1U);
  }
}

TEST(ModbusTouchpad, AnExceptionThatModbusDoesNotHaveIsSaidToBeThat) {
  for (const int code : {9, 12, 99, 255}) {
    ScriptedModbusDevice device([code](ScriptedModbusDevice&, int n) { return n == 2 ? code : 0; });
    Client ask(device);
    ASSERT_TRUE(ask());
    const auto refused = ask();
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text(), HasSubstr("a number that Modbus does not have")) << code;
  }
}

TEST(ModbusTouchpad, ATornBlockIsReadAgain) {
  ScriptedModbusDevice device([](ScriptedModbusDevice& d, int n) {
    d.sequence_end_ahead = n == 2 || n == 3 ? 1 : 0;
    return 0;
  });
  Client ask(device);
  ASSERT_TRUE(ask());
  ASSERT_TRUE(ask());
  EXPECT_EQ(ask.touchpad.counters().torn_blocks, 2U);
  EXPECT_EQ(ask.touchpad.counters().transactions, 4U);
}

TEST(ModbusTouchpad, ABlockThatIsAlwaysTornIsAnError) {
  ScriptedModbusDevice device([](ScriptedModbusDevice& d, int) {
    d.sequence_end_ahead = 1;
    return 0;
  });
  Client ask(device);
  EXPECT_THAT(ask().error().text(), HasSubstr("sequence numbers"));
}

TEST(ModbusTouchpad, AStaleAnswerIsNeverTaken) {
  ScriptedModbusDevice device([](ScriptedModbusDevice& d, int n) {
    d.echo_nonce = n % 2 == 0;  // an odd one repeats the nonce before
    return 0;
  });
  Client ask(device);
  for (int i = 0; i < 4; ++i) (void)ask();
  EXPECT_EQ(ask.touchpad.counters().stale_answers, 2U);
}

TEST(ModbusTouchpad, ComesBackAfterEachOfTwoHundredBrokenTransactions) {
  ScriptedModbusDevice device(
      [](ScriptedModbusDevice&, int n) { return n % 2 == 0 ? ScriptedModbusDevice::kClose : 0; });
  Client ask(device);
  for (int i = 0; i < 200; ++i) {
    const auto good = ask();
    ASSERT_TRUE(good) << i << ": " << good.error().text();
    ASSERT_FALSE(ask()) << i;
  }
  EXPECT_EQ(ask.touchpad.counters().connections, 200U);
}

TEST(ModbusTouchpad, ASilentDeviceIsNamedWithinTheTimeOutAndComesBack) {
  ScriptedModbusDevice device([](ScriptedModbusDevice&, int n) { return n == 2 ? ScriptedModbusDevice::kSilence : 0; });
  Client ask(device, waiting(500.0));
  ASSERT_TRUE(ask());
  EXPECT_THAT(ask().error().text(), HasSubstr("no answer in 500 ms"));
  EXPECT_TRUE(ask());
}

TEST(ModbusTouchpad, AnAnswerThatTricklesIsCutOffAtTheTimeOut) {
  ScriptedModbusDevice device([](ScriptedModbusDevice&, int n) { return n == 2 ? ScriptedModbusDevice::kTrickle : 0; });
  Client ask(device, waiting(500.0));
  ASSERT_TRUE(ask());
  const Instant before = Clock::now();
  EXPECT_THAT(ask().error().text(), HasSubstr("no answer in 500 ms"));
  EXPECT_LT(Clock::now() - before, std::chrono::seconds(3)) << "the whole answer would take 5.2 s";
  EXPECT_TRUE(ask());
}

TEST(ModbusTouchpad, MotorsAreSwitchedOnByARisingCommandOnly) {
  ScriptedModbusDevice device(kGood);
  Client ask(device);
  ASSERT_TRUE(ask());
  for (int i = 0; i < 6; ++i) ASSERT_TRUE(ask(true));
  EXPECT_EQ(protocol::driveStateOf(ask.touchpad.state().status_word), protocol::DriveState::operation_enabled);
  EXPECT_EQ(ask.touchpad.complaint().text(), "");
}

TEST(ModbusTouchpad, ADriveThatSwitchedItselfOffStaysOffUntilTheCommandHasBeenInactive) {
  ScriptedModbusDevice device([](ScriptedModbusDevice& d, int n) {
    if (n == 8) d.drive.fail(protocol::DriveFault::over_temperature);
    if (n == 8) d.state.status_word = statusBits(d.drive.state()) | protocol::status_bit::kRemote;
    d.state.fault_code = static_cast<std::uint16_t>(d.drive.fault());
    return 0;
  });
  Client ask(device);
  for (int i = 0; i < 7; ++i) ASSERT_TRUE(ask(true));
  const std::uint64_t before = ask(true)->motors.count;
  const auto after = ask(true);
  ASSERT_TRUE(after);
  EXPECT_EQ(after->motors.count, before) << "withheld, so that the step holds";
  EXPECT_THAT(ask.touchpad.complaint().text(), HasSubstr("over-temperature"));
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(ask(true));
  EXPECT_EQ(device.drive.state(), protocol::DriveState::fault);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(ask(false));
  EXPECT_EQ(ask.touchpad.complaint().text(), "");
  EXPECT_GT(ask(false)->motors.count, before);
  EXPECT_THAT(ask.touchpad.whySwitchedOff().text(), HasSubstr("over-temperature): mend that, then arm again"));
  ASSERT_TRUE(ask(true));
  EXPECT_EQ(ask.touchpad.whySwitchedOff().text(), "");
  for (int i = 0; i < 8; ++i) ASSERT_TRUE(ask(true));
  EXPECT_EQ(device.drive.state(), protocol::DriveState::operation_enabled);
}

TEST(ModbusTouchpad, ACommandThatTurnedActiveWhileTheDeviceWasAwayNeverMovesIt) {
  ScriptedModbusDevice device([](ScriptedModbusDevice&, int n) { return n == 2 ? ScriptedModbusDevice::kClose : 0; });
  Client ask(device);
  ASSERT_TRUE(ask(false));
  ASSERT_FALSE(ask(true));
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(ask(true));
  EXPECT_EQ(device.drive.state(), protocol::DriveState::switch_on_disabled);
  EXPECT_THAT(ask.touchpad.complaint().text(), HasSubstr("mend that, then arm again"));
}

}  // namespace
}  // namespace fyd::device
