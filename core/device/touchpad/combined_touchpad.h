// A touchpad whose motors have their own board: sensors from one source, motors from the qbmove. Each half has its
// own thread, so that neither waits for the other's time-outs; `exchange` only hands over the command and takes the
// newest readings.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

#include "core/base/latest_value.h"
#include "core/device/part_monitor.h"
#include "core/device/touchpad/qbmove_motors.h"
#include "core/device/touchpad/touchpad.h"

namespace fyd::device {

class CombinedTouchpad final : public Touchpad {
 public:
  CombinedTouchpad(std::unique_ptr<Touchpad> sensors, std::unique_ptr<QbmoveMotors> motors,
                   const DeviceParameters& parameters);
  /// Switches the motors off and joins the threads.
  ~CombinedTouchpad() override;

  [[nodiscard]] Message description() const override;
  /// The first call starts the threads, which inherit the caller's priority. The sensors' source never sees an active
  /// command. While one half fails the other's readings go on and `complaint` names the fault.
  /// @return an error when both fail, and before either has answered
  [[nodiscard]] Result<TouchpadReadings> exchange(const control::MotorCommand& command, Instant now) override;
  [[nodiscard]] Message complaint() const override;
  [[nodiscard]] Message whySwitchedOff() const override;
  [[nodiscard]] std::vector<DeviceReport> reports() const override;
  /// 1 ms: the motor board takes no batches of vibration duties, so each exchange carries one.
  [[nodiscard]] Duration period() const override { return std::chrono::milliseconds(1); }

 private:
  struct Given {
    control::MotorCommand command;
    Instant when{};
  };

  /// One half: its state, and the newest report of its device. Its thread writes, the others read.
  class Half {
   public:
    Half(Part part, Message waiting) : monitor(part, {}, Duration::max(), std::move(waiting)) {}
    PartMonitor monitor;
    std::atomic<bool> failing{true};  ///< its last exchange failed, or there was none; a complaint alone is no failure
    /// True ten times a second: the device's report is to be renewed.
    [[nodiscard]] bool reportDue(Instant now);
    void publish(DeviceReport report);
    void remember(Message why_switched_off);
    [[nodiscard]] Message whySwitchedOff() const;
    [[nodiscard]] Message description(const Message& fallback) const;
    [[nodiscard]] DeviceReport report(Instant now) const;

   private:
    mutable std::mutex mutex_;
    DeviceReport report_;
    Message why_switched_off_;
    Instant report_due_{};  // used by its own thread only
  };

  void runSensors(const std::stop_token& stop);
  void runMotors(const std::stop_token& stop);
  [[nodiscard]] Result<control::MotorFeedback> exchangeWithMotors(Instant now);

  std::unique_ptr<Touchpad> sensors_;
  std::unique_ptr<QbmoveMotors> motors_;
  const Message names_;  // description until both halves have reported
  const Duration longest_silence_;
  LatestValue<Given> command_;
  LatestValue<TouchpadReadings> sensed_;
  LatestValue<Timed<control::MotorFeedback>> moved_;
  TouchpadReadings readings_;
  Half sensor_half_{Part::touchpad, say("sensors: nothing received yet")};
  Half motor_half_{Part::motor_board, say("motor board: nothing received yet")};
  std::jthread sensor_thread_;
  std::jthread motor_thread_;
};

}  // namespace fyd::device
