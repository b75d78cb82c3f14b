// The register map: its own consistency, blocks written to and read from hand-made registers, the motors' state
// machine.
#include "core/protocol/registers/register_codec.h"

#include <bit>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/protocol/registers/drive_state.h"

namespace fyd::protocol {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(RegisterMap, NoAddressOrNameIsUsedTwiceAndThirtyTwoBitsLieOnEvenOnes) {
  std::set<int> used;
  std::set<std::string_view> names;
  for (const RegisterInfo& info : kRegisters) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    for (int i = 0; i < info.registers; ++i) EXPECT_TRUE(used.insert(info.address + i).second) << info.name;
    const bool wide = info.type == RegisterType::u32 || info.type == RegisterType::f32;
    EXPECT_TRUE(!wide || (info.address % 2 == 0 && info.registers == 2)) << info.name;
    EXPECT_FALSE(info.help.empty()) << info.name;
  }
}

TEST(RegisterMap, TheCyclicBlocksHaveNoHolesAndTheStateIsBracketed) {
  for (int i = 0; i < kStateRegisters; ++i) {
    const RegisterInfo* info = registerAt(static_cast<std::uint16_t>(kStateAddress + i));
    ASSERT_NE(info, nullptr) << i;
    EXPECT_EQ(info->access, RegisterAccess::read);
  }
  for (int i = 0; i < kCommandRegisters; ++i) {
    const RegisterInfo* info = registerAt(static_cast<std::uint16_t>(kCommandAddress + i));
    ASSERT_NE(info, nullptr) << i;
    EXPECT_EQ(info->access, RegisterAccess::write);
  }
  EXPECT_EQ(addressOf("sequence_begin"), kStateAddress);
  EXPECT_EQ(addressOf("sequence_end"), kStateAddress + kStateRegisters - 1);
  EXPECT_EQ(registerAt(50), nullptr);
  EXPECT_LE(kStateRegisters, 125);    // what one transaction of function 0x17 reads
  EXPECT_LE(kCommandRegisters, 121);  // and writes
}

TEST(RegisterMap, ThePrintedTableNamesEveryRegisterAndState) {
  const std::string table = registerMapMarkdown();
  for (const RegisterInfo& info : kRegisters) EXPECT_NE(table.find(fmt::format("`{}`", info.name)), std::string::npos);
  EXPECT_NE(table.find("| 4 | operation enabled | 0x27 |"), std::string::npos);
}

TEST(RegisterCodec, ReadsABlockWrittenByHand) {
  // In the order of the map: 7, nonce 0x1234, 65537 µs, operation enabled with voltage, no fault, 1.5 mV/V as ABCD …
  const StateRegisters registers = {7,  0x1234, 1,    1, 0x0037, 0,  0x3FC0, 0,      12,  300, 0, 4095, 2048,
                                    81, 5,      4095, 0, 0xFFEA, 11, 9950,   0xD8F0, 850, 230, 3, 1,    7};
  DeviceState state;
  ASSERT_EQ(decode(registers, state), StateProblem::none);
  EXPECT_EQ(state.sequence, 7);
  EXPECT_EQ(state.nonce_echo, 0x1234);
  EXPECT_EQ(state.uptime_us, 65537U);
  EXPECT_EQ(driveStateOf(state.status_word), DriveState::operation_enabled);
  EXPECT_EQ(state.bridge_mV_per_V, 1.5F);
  EXPECT_DOUBLE_EQ(state.bridge_age_ms, 1.2);
  EXPECT_EQ(state.bridge_count, 300);
  EXPECT_EQ(state.ir, (std::array<std::uint16_t, 3>{0, 4095, 2048}));
  EXPECT_DOUBLE_EQ(state.ir_age_ms, 8.1);
  EXPECT_EQ(state.motors.encoder_counts[0], 4095);
  EXPECT_EQ(state.motors.current_mA[0], -22.0);
  EXPECT_EQ(state.motors.current_mA[1], 11.0);
  EXPECT_TRUE(state.motors.position_duty_known);
  EXPECT_DOUBLE_EQ(state.motors.position_duty_percent[0], 99.5);
  EXPECT_DOUBLE_EQ(state.motors.position_duty_percent[1], -100.0);
  EXPECT_DOUBLE_EQ(state.temperature_degC[0], 85.0);
  EXPECT_EQ(encode(state), registers);
}

TEST(RegisterCodec, NamesWhatIsWrongWithABlock) {
  DeviceState good;
  good.status_word = statusBits(DriveState::switched_on);
  const StateRegisters registers = encode(good);
  const auto with = [&](std::string_view name, std::uint16_t value) {
    StateRegisters changed = registers;
    for (const RegisterInfo& info : kRegisters) {
      if (info.name == name) changed.at(info.address - kStateAddress) = value;
    }
    DeviceState state;
    return decode(changed, state);
  };
  EXPECT_EQ(with("sequence_begin", 0), StateProblem::none);
  EXPECT_EQ(with("sequence_begin", 1), StateProblem::torn);
  EXPECT_EQ(with("sequence_end", 65535), StateProblem::torn);
  EXPECT_EQ(with("status_word", 0x000B), StateProblem::bad_status);
  EXPECT_EQ(with("ir_2", 4096), StateProblem::bad_ir);
  EXPECT_EQ(with("encoder_1", 0x8000), StateProblem::bad_encoder);
  EXPECT_EQ(with("current_2", 10'000), StateProblem::none);
  EXPECT_EQ(with("current_2", 10'001), StateProblem::bad_current);
  EXPECT_EQ(with("current_1", 0x8000), StateProblem::bad_current);
  EXPECT_EQ(with("position_duty_1", 10'000), StateProblem::none);
  EXPECT_EQ(with("position_duty_1", 10'001), StateProblem::bad_duty);
  EXPECT_EQ(with("position_duty_2", 0x8000), StateProblem::none) << "not known";
  EXPECT_EQ(with("temperature_1", 2000), StateProblem::none);
  EXPECT_EQ(with("temperature_1", 0x7FFF), StateProblem::bad_temperature);
  EXPECT_EQ(with("temperature_2", 0x8000), StateProblem::bad_temperature);
}

TEST(RegisterCodec, WhatIsWrongIsSaidWithItsValue) {
  DeviceState state;
  state.temperature_degC = {3276.7, 23.0};
  EXPECT_EQ(describe(StateProblem::bad_temperature, state).text(),
            "motor temperatures 3276.7, 23.0 °C, expected -40 to 200");
  state.motors.current_mA = {32767.0, -5.0};
  EXPECT_EQ(describe(StateProblem::bad_current, state).text(), "motor currents 32767, -5 mA, expected -10000 to 10000");
}

TEST(RegisterCodec, SaturatesWhatDoesNotFit) {
  DeviceState state;
  state.status_word = statusBits(DriveState::fault);
  state.bridge_age_ms = 1e9;
  state.ir_age_ms = -5.0;
  state.motors.current_mA = {1e9, kNan};
  state.motors.position_duty_known = false;
  DeviceState back;
  ASSERT_EQ(decode(encode(state), back), StateProblem::bad_current);
  EXPECT_DOUBLE_EQ(back.bridge_age_ms, 6553.5);
  EXPECT_DOUBLE_EQ(back.ir_age_ms, 0.0);
  EXPECT_EQ(back.motors.current_mA[0], 32767.0);
  EXPECT_EQ(back.motors.current_mA[1], 0.0);
  EXPECT_FALSE(back.motors.position_duty_known);
}

TEST(RegisterCodec, CommandCarriesABatchOfDuties) {
  DeviceCommand command{.control_word = 0x0F, .heartbeat = 9, .nonce = 77, .reference_ticks = {4200, -4200}};
  command.vibration_batch = 5;
  ASSERT_TRUE(command.duties.push({100, -100}));
  ASSERT_TRUE(command.duties.push({-1, 25}));
  CommandRegisters registers{};
  ASSERT_EQ(encode(command, registers), 10U);
  EXPECT_EQ(registers[3], 4200);
  EXPECT_EQ(registers[4], 0xEF98);
  EXPECT_EQ(registers[7], 2);
  EXPECT_EQ(registers[8], 0x649C);
  EXPECT_EQ(registers[9], 0xFF19);
  DeviceCommand back;
  ASSERT_TRUE(decode({registers.data(), 10}, back));
  EXPECT_EQ(back.reference_ticks, command.reference_ticks);
  ASSERT_EQ(back.duties.size(), 2U);
  EXPECT_EQ(back.duties[1], (DutyPair{-1, 25}));
  EXPECT_FALSE(decode({registers.data(), 9}, back)) << "the count says two, one is there";
  registers[7] = kVibrationBatch + 1;
  EXPECT_FALSE(decode(registers, back));
  registers[7] = 0;
  registers[5] = 0;
  EXPECT_FALSE(decode(registers, back)) << "no rate";
}

TEST(RegisterCodec, DutiesAreRoundedLimitedAndNeverNan) {
  EXPECT_EQ(toDutyPair({kNan, 24.6}), (DutyPair{0, 25}));
  EXPECT_EQ(toDutyPair({1e300, -std::numeric_limits<double>::infinity()}), (DutyPair{100, -100}));
}

TEST(RegisterCodec, IdentityKeepsItsSerialAndShowsOnlyPrintableCharacters) {
  DeviceIdentity identity;
  identity.setSerial("FYD-0042 too long for it");
  EXPECT_EQ(decodeIdentity(encode(identity)).serialText(), "FYD-0042 too lon");
  IdentityRegisters registers = encode(identity);
  EXPECT_EQ(registers[0], 0x4659);
  EXPECT_EQ(registers[1], 0x4454);
  registers[6] = 0x4107;
  EXPECT_EQ(decodeIdentity(registers).serialText(), "FYD-A");
}

TEST(DriveState, EveryStateIsReadBackFromItsBitsWhateverTheOthersSay) {
  for (int i = 0; i < kDriveStates; ++i) {
    const auto state = static_cast<DriveState>(i);
    EXPECT_EQ(driveStateOf(statusBits(state)), state);
    EXPECT_EQ(driveStateOf(statusBits(state) | 0xFF90), state);
  }
}

TEST(DriveState, TheMasterLeadsItToOperationAndBack) {
  Drive drive;
  for (int i = 0; i < 3; ++i) drive.control(nextControlWord(drive.state(), true, false));
  EXPECT_TRUE(drive.energised());
  drive.control(nextControlWord(drive.state(), false, false));
  EXPECT_EQ(drive.state(), DriveState::switch_on_disabled);
}

TEST(DriveState, AFaultIsLeftByARisingResetOnly) {
  Drive drive;
  drive.control(control_word::kFaultReset);
  drive.fail(DriveFault::heartbeat);
  drive.fail(DriveFault::over_temperature);
  EXPECT_EQ(drive.fault(), DriveFault::heartbeat) << "the first cause stays";
  drive.control(control_word::kFaultReset);
  EXPECT_EQ(drive.state(), DriveState::fault) << "the bit was up before";
  drive.control(control_word::kEnableOperation);
  drive.control(control_word::kFaultReset);
  EXPECT_EQ(drive.state(), DriveState::switch_on_disabled);
  EXPECT_EQ(nextControlWord(DriveState::fault, true, false), control_word::kDisableVoltage);
}

TEST(DriveState, AQuickStopIsLeftByTakingTheVoltageAwayOnly) {
  Drive drive;
  for (int i = 0; i < 3; ++i) drive.control(nextControlWord(drive.state(), true, false));
  drive.control(control_word::kQuickStop);
  EXPECT_EQ(drive.state(), DriveState::quick_stop_active);
  EXPECT_FALSE(drive.energised());
  drive.control(control_word::kEnableOperation);
  EXPECT_FALSE(drive.energised());
  drive.control(control_word::kDisableVoltage);
  EXPECT_EQ(drive.state(), DriveState::switch_on_disabled);
}

TEST(DriveState, NoWordsWhateverLeadFromTheStartToOperationInFewerThanThreeSteps) {
  for (std::uint32_t first = 0; first <= 0xFFFF; first += 7) {
    Drive drive;
    drive.control(static_cast<std::uint16_t>(first));
    drive.control(control_word::kEnableOperation);
    EXPECT_FALSE(drive.energised());
  }
}

TEST(RegisterCodec, EachProblemIsSaidInItsOwnWords) {
  DeviceState state;
  state.status_word = 0x000B;
  state.ir = {4096, 0, 1};
  state.motors.encoder_counts = {5000, 2};
  state.motors.position_duty_percent = {327.67, -1.0};
  const auto said = [&](StateProblem problem) { return describe(problem, state).text(); };
  EXPECT_EQ(said(StateProblem::none), "no problem");
  EXPECT_THAT(said(StateProblem::torn), testing::HasSubstr("sequence numbers differ"));
  EXPECT_EQ(said(StateProblem::bad_status), "the status word 0x000B names no state");
  EXPECT_EQ(said(StateProblem::bad_ir), "IR codes 4096, 0, 1, expected 0 to 4095");
  EXPECT_EQ(said(StateProblem::bad_encoder), "encoder counts 5000, 2, expected 0 to 4095");
  EXPECT_EQ(said(StateProblem::bad_duty), "position duties 327.67, -1.00 %, expected -100 to 100");
  EXPECT_EQ(said(static_cast<StateProblem>(99)), "unknown problem");
}

TEST(RegisterCodec, ACommandOfAWrongLengthOrRateIsRefused) {
  CommandRegisters registers{};
  const std::size_t head = encode(DeviceCommand{}, registers);
  DeviceCommand back;
  EXPECT_TRUE(decode({registers.data(), head}, back));
  EXPECT_FALSE(decode({registers.data(), head - 1}, back));
  EXPECT_FALSE(decode(std::vector<std::uint16_t>(kCommandRegisters + 1), back));
  registers[5] = 0xFFFF;
  EXPECT_FALSE(decode({registers.data(), head}, back)) << "more duties a second than there may be";
}

TEST(DriveState, StatusAndFaultAreSaidInWords) {
  const std::uint16_t all = status_bit::kVoltageEnabled | status_bit::kWarning | status_bit::kRemote |
                            status_bit::kInternalLimit | status_bit::kWatchdogExpired;
  EXPECT_EQ(statusInWords(statusBits(DriveState::operation_enabled) | all),
            "operation enabled, voltage present, close to the thermal limit, this connection drives, "
            "limited by the device, heartbeat expired");
  EXPECT_EQ(statusInWords(0x000B), "no known state");
  EXPECT_EQ(toString(DriveFault::none), "none");
  EXPECT_EQ(toString(DriveFault::undervoltage), "supply undervoltage");
  EXPECT_EQ(toString(DriveFault::over_temperature), "motor over-temperature");
  EXPECT_EQ(toString(DriveFault::heartbeat), "heartbeat lost");
  EXPECT_EQ(toString(static_cast<DriveFault>(99)), "unknown fault");
  EXPECT_EQ(toString(static_cast<RegisterType>(99)), "?");
}

TEST(DriveState, EachStepOfTheWayUpAndDownIsTakenByItsOwnWordOnly) {
  // CiA 402: 6 shutdown, 7 switch on, 15 enable operation.
  const auto after = [](std::initializer_list<std::uint16_t> words) {
    Drive drive;
    for (const std::uint16_t word : words) drive.control(word);
    return drive.state();
  };
  EXPECT_EQ(after({6}), DriveState::ready_to_switch_on);
  EXPECT_EQ(after({6, 15}), DriveState::ready_to_switch_on) << "not two steps at once";
  EXPECT_EQ(after({6, 7}), DriveState::switched_on);
  EXPECT_EQ(after({6, 7, 6}), DriveState::ready_to_switch_on);
  EXPECT_EQ(after({6, 7, 15, 7}), DriveState::switched_on);
  EXPECT_EQ(after({6, 7, 15, 6}), DriveState::ready_to_switch_on);
  EXPECT_EQ(after({6, 7, 2}), DriveState::switch_on_disabled) << "quick stop before operation";
  EXPECT_EQ(after({6, 7, 15, 2, 2}), DriveState::quick_stop_active);
  Drive failed;
  failed.fail(DriveFault::heartbeat);
  EXPECT_EQ(nextControlWord(failed.state(), true, true), control_word::kFaultReset);
  for (const DriveState waits :
       {DriveState::not_ready_to_switch_on, DriveState::quick_stop_active, DriveState::fault_reaction_active}) {
    EXPECT_EQ(nextControlWord(waits, true, true), control_word::kDisableVoltage);
  }
  EXPECT_EQ(nextControlWord(static_cast<DriveState>(99), true, true), control_word::kDisableVoltage);
}

}  // namespace
}  // namespace fyd::protocol
