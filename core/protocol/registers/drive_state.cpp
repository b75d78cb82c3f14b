#include "core/protocol/registers/drive_state.h"

#include <array>

#include "core/base/message.h"

namespace fyd::protocol {
namespace {

struct Pattern {
  std::uint16_t mask;
  std::uint16_t bits;
  std::string_view name;
};

// In the order of DriveState. Bit 5, quick stop, counts the other way round: 0 means it is active.
constexpr std::array<Pattern, kDriveStates> kPatterns = {{
    {0x4F, 0x00, sentence("not ready to switch on")},
    {0x4F, 0x40, sentence("switch-on disabled")},
    {0x6F, 0x21, sentence("ready to switch on")},
    {0x6F, 0x23, sentence("switched on")},
    {0x6F, 0x27, sentence("operation enabled")},
    {0x6F, 0x07, sentence("quick stop active")},
    {0x4F, 0x0F, sentence("fault reaction active")},
    {0x4F, 0x08, sentence("fault")},
}};

constexpr std::uint16_t kVoltage = 0x02;
constexpr std::uint16_t kNotQuickStop = 0x04;
constexpr std::uint16_t kCommandBits = 0x0F;

}  // namespace

std::string_view toString(DriveState state) { return kPatterns.at(static_cast<std::size_t>(state)).name; }

std::string_view toString(DriveFault fault) {
  switch (fault) {
    case DriveFault::none: return sentence("none");
    case DriveFault::undervoltage: return sentence("supply undervoltage");
    case DriveFault::over_temperature: return sentence("motor over-temperature");
    case DriveFault::heartbeat: return sentence("heartbeat lost");
  }
  return sentence("unknown fault");
}

std::uint16_t statusBits(DriveState state) { return kPatterns.at(static_cast<std::size_t>(state)).bits; }

std::optional<DriveState> driveStateOf(std::uint16_t status_word) {
  for (std::size_t i = 0; i < kPatterns.size(); ++i) {
    if ((status_word & kPatterns[i].mask) == kPatterns[i].bits) return static_cast<DriveState>(i);
  }
  return std::nullopt;
}

std::string statusInWords(std::uint16_t status_word) {
  struct Bit {
    std::uint16_t mask;
    std::string_view words;
  };
  constexpr std::array<Bit, 5> kBits = {{{status_bit::kVoltageEnabled, "voltage present"},
                                         {status_bit::kWarning, "close to the thermal limit"},
                                         {status_bit::kRemote, "this connection drives"},
                                         {status_bit::kInternalLimit, "limited by the device"},
                                         {status_bit::kWatchdogExpired, "heartbeat expired"}}};
  const auto state = driveStateOf(status_word);
  std::string out(state ? toString(*state) : "no known state");
  for (const Bit& bit : kBits) {
    if ((status_word & bit.mask) != 0) out.append(", ").append(bit.words);
  }
  return out;
}

std::uint16_t nextControlWord(DriveState state, bool operate, bool reset_fault) {
  if (!operate) return control_word::kDisableVoltage;
  switch (state) {
    case DriveState::switch_on_disabled: return control_word::kShutdown;
    case DriveState::ready_to_switch_on: return control_word::kSwitchOn;
    case DriveState::switched_on:
    case DriveState::operation_enabled: return control_word::kEnableOperation;
    case DriveState::fault: return reset_fault ? control_word::kFaultReset : control_word::kDisableVoltage;
    case DriveState::not_ready_to_switch_on:
    case DriveState::quick_stop_active:
    case DriveState::fault_reaction_active: break;
  }
  return control_word::kDisableVoltage;
}

void Drive::control(std::uint16_t word) {
  const bool reset = (word & control_word::kFaultReset) != 0 && (last_word_ & control_word::kFaultReset) == 0;
  last_word_ = word;
  if (state_ == DriveState::fault) {
    if (reset) {
      state_ = DriveState::switch_on_disabled;
      fault_ = DriveFault::none;
    }
    return;
  }
  if ((word & kVoltage) == 0) {
    state_ = DriveState::switch_on_disabled;
    return;
  }
  if ((word & kNotQuickStop) == 0) {
    if (state_ == DriveState::operation_enabled) {
      state_ = DriveState::quick_stop_active;
    } else if (state_ != DriveState::quick_stop_active) {
      state_ = DriveState::switch_on_disabled;
    }
    return;
  }
  const std::uint16_t asked = word & kCommandBits;
  switch (state_) {
    case DriveState::switch_on_disabled:
      if (asked == control_word::kShutdown) state_ = DriveState::ready_to_switch_on;
      break;
    case DriveState::ready_to_switch_on:
      if (asked == control_word::kSwitchOn) state_ = DriveState::switched_on;
      break;
    case DriveState::switched_on:
    case DriveState::operation_enabled:
      if (asked == control_word::kEnableOperation) state_ = DriveState::operation_enabled;
      if (asked == control_word::kSwitchOn) state_ = DriveState::switched_on;
      if (asked == control_word::kShutdown) state_ = DriveState::ready_to_switch_on;
      break;
    default: break;  // a quick stop is left by taking the voltage away
  }
}

void Drive::fail(DriveFault fault) {
  if (state_ == DriveState::fault) return;
  state_ = DriveState::fault;
  fault_ = fault;
}

}  // namespace fyd::protocol
