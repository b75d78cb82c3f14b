// A touchpad whose motors hang on their own board: sensors from one source, motors from the qbmove.
#pragma once

#include <memory>

#include "core/device/qbmove_motors.h"
#include "core/device/touchpad.h"

namespace fyd::device {

class CombinedTouchpad final : public Touchpad {
 public:
  CombinedTouchpad(std::unique_ptr<Touchpad> sensors, std::unique_ptr<QbmoveMotors> motors)
      : sensors_(std::move(sensors)), motors_(std::move(motors)) {}

  [[nodiscard]] std::string description() const override;
  /// The sensors' source never sees an active command. While one half fails the other's readings go on and `complaint`
  /// tells what fails.
  /// @return an error when both fail
  [[nodiscard]] Result<TouchpadReadings> exchange(const control::MotorCommand& command, Instant now) override;
  [[nodiscard]] std::string complaint() const override;
  /// The motor board has no batches: a duty is held until the next exchange.
  [[nodiscard]] Duration period() const override { return std::chrono::milliseconds(1); }

 private:
  void askSensors(Instant now);
  void askMotors(const control::MotorCommand& command, Instant now);

  std::unique_ptr<Touchpad> sensors_;
  std::unique_ptr<QbmoveMotors> motors_;
  TouchpadReadings readings_;
  std::string sensor_problem_;
  std::string motor_problem_;
  Instant sensors_due_{};
  Instant motors_due_{};
  int motor_failures_ = 0;  // in a row
};

}  // namespace fyd::device
