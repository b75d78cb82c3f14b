// The touchpad over Modbus: one transaction of function 0x17 a cycle writes the command and reads the state.
//
// Freshness: each cycle writes a new nonce and takes only an answer that echoes it. Arming: the motors are switched on
// only by a command that turns active; when the device switches them off by itself, restarts or vanishes, they stay
// off until the command has been inactive. Until then their readings are withheld, so that the step holds. They are
// withheld as well while the device reports that it does not obey (bit 9 of the status word), and while its set of
// values is not renewed.
//
// A device whose clock restarted is identified and set up anew, also on a line that stayed open: it may be another one.
#pragma once

#include <optional>

#include "core/device/device_parameters.h"
#include "core/device/touchpad/modbus_link.h"
#include "core/device/touchpad/touchpad.h"
#include "core/protocol/registers/drive_state.h"
#include "core/protocol/registers/register_codec.h"

namespace fyd::device {

/// Whether the device's microsecond clock, which wraps at 32 bit, restarted between two readings `elapsed` apart.
[[nodiscard]] bool deviceRestarted(std::uint32_t before_us, std::uint32_t now_us, Duration elapsed);

/// Counters since the start, for the window and the tests.
struct ModbusTouchpadCounters {
  std::uint64_t transactions = 0;
  std::uint64_t stale_answers = 0;  ///< refused: they echoed another nonce
  std::uint64_t torn_blocks = 0;    ///< read again
  std::uint64_t connections = 0;
  std::uint64_t restarts = 0;     ///< of the device, seen by its clock
  std::uint64_t duties_lost = 0;  ///< older than one batch holds
};

class ModbusTouchpad final : public Touchpad {
 public:
  /// Opens nothing yet; the first exchange does.
  ModbusTouchpad(const ModbusAddress& address, const DeviceParameters& parameters);
  ~ModbusTouchpad() override;

  [[nodiscard]] Message description() const override;
  /// Opens and identifies the device first when that is to be done. A lost answer costs the response time-out, on RTU
  /// also quiet_ms, up to 500 ms on a line that is never quiet; opening such a line always waits for that silence. One
  /// exchange may wait for up to three answers more when it opens (the connection's, identity, settings), and for up to
  /// four of one torn block.
  [[nodiscard]] Result<TouchpadReadings> exchange(const control::MotorCommand& command, Instant now) override;
  /// Connects, asks, and closes again; writes nothing. @return empty when it tells no serial number
  [[nodiscard]] Result<std::string> askSerial();
  void queueVibration(std::span<const VibrationDuty> duties) override;
  [[nodiscard]] Message complaint() const override;
  [[nodiscard]] Message whySwitchedOff() const override;
  [[nodiscard]] std::vector<DeviceReport> reports() const override;
  [[nodiscard]] Duration period() const override { return period_; }

  [[nodiscard]] const ModbusTouchpadCounters& counters() const { return counters_; }
  [[nodiscard]] const protocol::DeviceState& state() const { return state_; }
  [[nodiscard]] const protocol::DeviceIdentity& identity() const { return identity_; }

 private:
  enum class Arming : std::uint8_t { off, switching_on, on, refused };

  [[nodiscard]] Result<void> connect();
  [[nodiscard]] Result<void> checkIdentity();
  void followCommand(bool active);
  void followDrive(protocol::DriveState state);
  void followObedience();
  void prepare(const control::MotorCommand& command);
  [[nodiscard]] Result<void> transact();
  [[nodiscard]] tl::unexpected<Error> lost(Error error);
  [[nodiscard]] Result<void> checkClock(Instant now);
  void take(Instant now);

  DeviceParameters parameters_;
  std::string expected_serial_;  // as configured, or of the first touchpad that answered; empty: any
  ModbusLink link_;
  Duration period_;
  protocol::DeviceIdentity identity_;
  protocol::DeviceCommand command_;
  protocol::DeviceState state_;
  TouchpadReadings readings_;
  ModbusTouchpadCounters counters_;
  Arming arming_ = Arming::off;
  bool was_active_ = false;
  bool acknowledge_fault_ = false;
  int cycles_switching_on_ = 0;
  Message refusal_;  // why the motors went off while the command wanted them on; until it turns active again
  protocol::DriveState drive_ = protocol::DriveState::not_ready_to_switch_on;  // as last reported
  bool obeys_ = true;
  bool stands_still_ = false;
  struct ValueSet {
    std::uint16_t sequence = 0;
    std::uint32_t uptime_us = 0;
  };
  std::optional<ValueSet> last_set_;  // kept over a new connection, so that an old set is not taken for a new one
  Instant last_new_set_{};
  std::optional<std::uint32_t> last_uptime_us_;
  std::uint16_t last_ir_count_ = 0;
  std::uint16_t last_bridge_count_ = 0;
  Instant last_answer_{};
  bool identified_ = false;
};

}  // namespace fyd::device
