// State machine of the touchpad's motors in the manner of CiA 402 [IEC 61800-7]: the status word, the control word, and
// the machine itself as the device runs it. Pure; no allocation.
//
//   not ready ─▶ switch-on disabled ─shutdown─▶ ready ─switch on─▶ switched on ─enable─▶ operation enabled
//   any ─▶ fault (motors off), left by a rising fault-reset bit only; quick stop and a lost voltage bit lead back
//
// Status word, bits 0…3, 5, 6 tell the state as CiA 402 draws them; the bits below are this device's own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fyd::protocol {

enum class DriveState : std::uint8_t {
  not_ready_to_switch_on,
  switch_on_disabled,
  ready_to_switch_on,
  switched_on,
  operation_enabled,
  quick_stop_active,
  fault_reaction_active,
  fault,
};
inline constexpr int kDriveStates = 8;

[[nodiscard]] std::string_view toString(DriveState state);

namespace status_bit {
inline constexpr std::uint16_t kVoltageEnabled = 1U << 4U;
inline constexpr std::uint16_t kWarning = 1U << 7U;           ///< a motor is within 10 °C of its thermal limit
inline constexpr std::uint16_t kRemote = 1U << 9U;            ///< this connection's writes are obeyed
inline constexpr std::uint16_t kInternalLimit = 1U << 11U;    ///< a duty or reference was limited by the device
inline constexpr std::uint16_t kWatchdogExpired = 1U << 14U;  ///< the heartbeat did not change in time
}  // namespace status_bit

/// Control words.
namespace control_word {
inline constexpr std::uint16_t kDisableVoltage = 0x0000;
inline constexpr std::uint16_t kQuickStop = 0x0002;
inline constexpr std::uint16_t kShutdown = 0x0006;
inline constexpr std::uint16_t kSwitchOn = 0x0007;
inline constexpr std::uint16_t kEnableOperation = 0x000F;
inline constexpr std::uint16_t kFaultReset = 0x0080;  ///< its rising edge acts
}  // namespace control_word

/// Why the motors are in the state `fault`; numbers as CiA 402 devices use them.
enum class DriveFault : std::uint16_t {
  none = 0x0000,
  undervoltage = 0x3220,      ///< the supply voltage dropped; also after a restart caused by that
  over_temperature = 0x4310,  ///< a motor's temperature estimate passed the thermal limit
  heartbeat = 0x8130,         ///< the heartbeat did not change for longer than the watchdog allows
};
[[nodiscard]] std::string_view toString(DriveFault fault);

/// The state's bits of the status word.
[[nodiscard]] std::uint16_t statusBits(DriveState state);
/// @return nothing for a combination that no state has
[[nodiscard]] std::optional<DriveState> driveStateOf(std::uint16_t status_word);

/// "operation enabled, voltage present, this connection drives": the state and the bits that are set.
[[nodiscard]] std::string statusInWords(std::uint16_t status_word);

/// The control word that leads from `state` one step towards operation, or the motors off.
/// @param reset_fault whether a fault may be acknowledged on the way: the operator has just armed
[[nodiscard]] std::uint16_t nextControlWord(DriveState state, bool operate, bool reset_fault);

/// The device's side.
class Drive {
 public:
  [[nodiscard]] DriveState state() const { return state_; }
  [[nodiscard]] DriveFault fault() const { return fault_; }
  [[nodiscard]] bool energised() const { return state_ == DriveState::operation_enabled; }

  /// Obeys one control word; one transition a call.
  void control(std::uint16_t word);
  /// Motors off until a fault reset; the first cause is kept.
  void fail(DriveFault fault);

 private:
  DriveState state_ = DriveState::switch_on_disabled;
  DriveFault fault_ = DriveFault::none;
  std::uint16_t last_word_ = 0;
};

}  // namespace fyd::protocol
