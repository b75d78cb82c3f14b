// The original motor board (qbrobotics qbmove) on its own serial line: activation, references, vibration,
// measured positions and currents. The board closes the position loop.
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/base/time.h"
#include "core/base/timed.h"
#include "core/control/motor_types.h"
#include "core/device/device_parameters.h"
#include "core/device/device_report.h"
#include "core/device/serial_port.h"
#include "core/protocol/qbmove_codec.h"

namespace fyd::device {

/// Encoder counts 0…4095 for a measured position of the board, in its ticks.
[[nodiscard]] std::uint16_t encoderCountsOf(std::int16_t ticks, const DeviceParameters& parameters);

class QbmoveMotors {
 public:
  /// Opens nothing yet; the first exchange does.
  QbmoveMotors(std::string port, const DeviceParameters& parameters);

  [[nodiscard]] Message description() const;

  /// Writes the command, reads positions and currents. The motors are activated by a command that turns active only;
  /// after the board was lost (gone, or three exchanges in a row without a reply) or has switched its motors off by
  /// itself, the command has to turn inactive first, and until then this is an error. While the command is inactive the
  /// board is told to switch off until it says that it is; that it says otherwise is an error.
  /// @param renewed false: an old command, whose giver has fallen silent. The motors go off, and what was active has to
  /// turn inactive first: their return is the operator's
  /// @return an error that names the port, what was missing and the remedy
  [[nodiscard]] Result<control::MotorFeedback> exchange(const control::MotorCommand& command, bool renewed = true);

  /// Kind, description, counters and values; the caller fills in rate, age, errors and problem.
  [[nodiscard]] DeviceReport report() const;
  /// As of Touchpad.
  [[nodiscard]] Message whySwitchedOff() const;

 private:
  [[nodiscard]] Result<void> connect();
  [[nodiscard]] Result<void> send(protocol::QbmoveFrame frame);
  [[nodiscard]] Result<protocol::QbmoveFrame> ask(std::uint8_t command, std::size_t payload_bytes);
  [[nodiscard]] Result<void> follow(const control::MotorCommand& command);
  [[nodiscard]] Result<control::MotorFeedback> measure();
  [[nodiscard]] Result<void> checkActivation();
  void lose(std::string_view why);
  void refuse(std::string_view why);

  std::string path_;
  DeviceParameters parameters_;
  std::optional<SerialPort> port_;
  protocol::QbmoveParser parser_;
  bool energised_ = false;
  bool off_confirmed_ = false;  // the board has said that its motors are off
  bool was_active_ = false;
  bool refused_ = false;  // the motors stay off although the command wants them on
  Message refusal_;       // why; until the command turns active again
  int failures_ = 0;      // in a row
  int exchanges_ = 0;
  std::uint64_t late_replies_ = 0;
  std::uint64_t connections_ = 0;
  std::uint64_t switched_off_ = 0;  // by itself
  Timed<control::MotorFeedback> newest_;
};

}  // namespace fyd::device
