// Interface of a touchpad; implemented by the simulated, Modbus, motor-board and recorded ones.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/timed.h"
#include "core/control/motor_types.h"
#include "core/device/device_report.h"
#include "core/sensing/readings.h"

namespace fyd::device {

/// Each quantity with the instant its sensor took it; one without a new reading keeps its old instant and count.
struct TouchpadReadings {
  Timed<sensing::IrCounts> ir;
  Timed<sensing::BridgeReading> bridge;
  Timed<control::MotorFeedback> motors;
};

/// Duties of the motors for one step of the haptic loop, percent.
using VibrationDuty = std::array<double, control::kMotorCount>;

/// So many times at most a device that is left is told that its motors shall be off, until it answers.
inline constexpr int kFarewells = 5;

/// Used by one thread at a time (the station's device thread).
class Touchpad {
 public:
  virtual ~Touchpad() = default;

  /// "simulated touchpad, seed 1" or the port and identity of a real one.
  [[nodiscard]] virtual Message description() const = 0;

  /// Writes the command and reads what there is, as one exchange.
  /// @param now the station's clock
  /// @return an error when the device did not answer
  [[nodiscard]] virtual Result<TouchpadReadings> exchange(const control::MotorCommand& command, Instant now) = 0;

  /// The loop's duties since the last exchange, oldest first, one a millisecond; the next exchange carries them to
  /// devices that play batches. Others take the duty in the command and ignore this.
  virtual void queueVibration(std::span<const VibrationDuty> duties) { static_cast<void>(duties); }

  /// Whether its motors follow the command; those of a recording do not.
  [[nodiscard]] virtual bool driven() const { return true; }

  /// What the device complains of although it answers (motors switched off by itself, …), and the remedy; or empty.
  [[nodiscard]] virtual Message complaint() const { return {}; }

  /// Why its motors last went off by themselves, and the remedy: until a command that turns active, also while nothing
  /// is wrong any more. Or empty.
  [[nodiscard]] virtual Message whySwitchedOff() const { return {}; }

  /// A report for each part, with live values. If there is only one, the caller fills in its rate, age, errors and
  /// problem; several fill in their own.
  [[nodiscard]] virtual std::vector<DeviceReport> reports() const { return {}; }

  /// The longest a caller should wait between two exchanges.
  [[nodiscard]] virtual Duration period() const = 0;
};

}  // namespace fyd::device
