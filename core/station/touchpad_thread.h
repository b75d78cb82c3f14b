// The device thread: exchanges with the touchpad at its own rate and applies the command timeout. When the haptic loop
// has written no command for 20 ms, vibration goes to zero and the references stay.
#pragma once

#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "core/base/latest_value.h"
#include "core/base/ring.h"
#include "core/control/motor_types.h"
#include "core/device/part_monitor.h"
#include "core/device/touchpad/frozen_readings.h"
#include "core/device/touchpad/plausibility.h"
#include "core/device/touchpad/touchpad.h"

namespace fyd::station {

/// A command and when the step gave it.
struct StampedMotorCommand {
  control::MotorCommand command;
  Instant given{};
  bool released = false;  ///< off because the motors were given up while Held: why is still to be shown
};

inline constexpr Duration kCommandTimeout = std::chrono::milliseconds(20);

/// The command sent to the motors at `now` when `stamped` is the newest one.
[[nodiscard]] control::MotorCommand guardedCommand(const StampedMotorCommand& stamped, Instant now);

class TouchpadThread {
 public:
  /// @param clock_waits everything is simulated: the session's clock waits for this thread
  explicit TouchpadThread(std::unique_ptr<device::Touchpad> touchpad, const device::DeviceParameters& parameters = {},
                          bool clock_waits = false);
  ~TouchpadThread();

  void start();
  /// Sends one last command with the motors off, then joins.
  void shutDown();

  LatestValue<StampedMotorCommand> command;        ///< written by the haptic loop
  Ring<device::VibrationDuty> duties{256};         ///< written by the haptic loop, one a step
  LatestValue<device::TouchpadReadings> readings;  ///< read by the haptic loop
  [[nodiscard]] device::DeviceReport status(Instant now) const { return monitor_.report(now); }
  /// What it consists of; a touchpad of one device has the status' rate, age and problem.
  [[nodiscard]] std::vector<device::DeviceReport> reports(Instant now) const;

 private:
  void run(const std::stop_token& stop);
  void takeDuties();
  void report(Instant now, bool released);
  void publishReports(Instant now);

  std::unique_ptr<device::Touchpad> touchpad_;
  device::Plausibility plausibility_;
  device::FrozenReadings frozen_;
  device::PartMonitor monitor_;
  const bool clock_waits_;
  bool answering_ = false;
  Instant reports_due_{};
  mutable std::mutex reports_mutex_;
  std::vector<device::DeviceReport> reports_;
  std::jthread thread_;
};

}  // namespace fyd::station
