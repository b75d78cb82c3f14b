// A touchpad whose motors hang on their own board: sensors from one source, motors from the qbmove. Each half has its
// own thread, so that neither waits for the other's time-outs; `exchange` only hands over and takes what is there.
#pragma once

#include <memory>
#include <mutex>
#include <thread>

#include "core/base/latest_value.h"
#include "core/base/rate_meter.h"
#include "core/device/qbmove_motors.h"
#include "core/device/touchpad.h"

namespace fyd::device {

class CombinedTouchpad final : public Touchpad {
 public:
  CombinedTouchpad(std::unique_ptr<Touchpad> sensors, std::unique_ptr<QbmoveMotors> motors,
                   const DeviceParameters& parameters);
  /// Switches the motors off and joins the threads.
  ~CombinedTouchpad() override;

  [[nodiscard]] Message description() const override;
  /// The first call starts the threads, which inherit the caller's priority. The sensors' source never sees an active
  /// command. While one half fails the other's readings go on and `complaint` tells what fails.
  /// @return an error when both fail, and before either has answered
  [[nodiscard]] Result<TouchpadReadings> exchange(const control::MotorCommand& command, Instant now) override;
  [[nodiscard]] Message complaint() const override;
  [[nodiscard]] std::vector<DeviceReport> reports() const override;
  /// The motor board has no batches: a duty is held until the next exchange.
  [[nodiscard]] Duration period() const override { return std::chrono::milliseconds(1); }

 private:
  struct Given {
    control::MotorCommand command;
    Instant when{};
  };

  /// How one half is doing: its thread writes, the others read.
  class Half {
   public:
    explicit Half(Message waiting) : problem_(std::move(waiting)) {}
    void succeeded(Instant now, const Message& complaint);
    void failed(const Message& problem);
    /// Ten times a second it is worth asking the device for a report.
    [[nodiscard]] bool reportDue(Instant now);
    void publish(DeviceReport report);
    [[nodiscard]] Message problem() const;
    [[nodiscard]] Message description(const Message& fallback) const;
    [[nodiscard]] DeviceReport report(Instant now) const;

   private:
    mutable std::mutex mutex_;
    Message problem_;
    DeviceReport report_;
    std::uint64_t errors_ = 0;
    bool seen_ = false;
    Instant newest_{};
    RateMeter rate_;
    Instant report_due_{};  // its thread's own
  };

  void runSensors(const std::stop_token& stop);
  void runMotors(const std::stop_token& stop);
  [[nodiscard]] control::MotorCommand commandAt(Instant now);

  std::unique_ptr<Touchpad> sensors_;
  std::unique_ptr<QbmoveMotors> motors_;
  const Message names_;  // until they say more
  const Duration longest_silence_;
  LatestValue<Given> command_;
  LatestValue<TouchpadReadings> sensed_;
  LatestValue<Timed<control::MotorFeedback>> moved_;
  TouchpadReadings readings_;
  Half sensor_half_{say("sensors: nothing received yet")};
  Half motor_half_{say("motor board: nothing received yet")};
  std::jthread sensor_thread_;
  std::jthread motor_thread_;
};

}  // namespace fyd::device
