// The touchpad of a soak: the simulated world behind its real servers, the real drivers in front of them, over a TCP
// connection and a pseudo-terminal; all in virtual time. The camera's pictures go through JPEG, with the stream's faults.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "core/device/camera/frozen_picture.h"
#include "core/device/camera/picture_decoder.h"
#include "core/device/touchpad/frozen_readings.h"
#include "core/device/touchpad/modbus_touchpad.h"
#include "core/device/touchpad/plausibility.h"
#include "core/device/touchpad/qbmove_motors.h"
#include "core/pipeline/pipeline.h"
#include "core/sensing/finger_detector.h"
#include "core/sim/server/modbus_server.h"
#include "core/sim/server/qbmove_server.h"
#include "core/sim/touchpad/simulated_camera.h"
#include "tests/soak/soak_checks.h"

namespace fyd::soak {

class SoakTouchpad {
 public:
  /// @param own_board the motors have their own board, as the thesis' touchpad
  SoakTouchpad(const pipeline::Parameters& parameters, const sim::FingerPath& finger, bool own_board,
               const std::string& folder, int seed, Instant start);

  /// A millisecond: exchanges what is due and puts what is believed into `inputs`.
  void advance(Instant now, const control::MotorCommand& command, pipeline::Inputs& inputs);

  /// Begins a fault of chance. @return by when Active must have ended, where it must
  std::optional<Deadline> disturb(Chance& chance, Instant now, Figures& figures);
  /// Of the camera alone.
  std::optional<Deadline> disturbCamera(Chance& chance, Instant now, Figures& figures);
  /// Every fault that it may begin, with a count of 0.
  static void nameFaults(Figures& figures);

  [[nodiscard]] const cv::Mat& picture() const { return picture_; }
  [[nodiscard]] std::uint64_t pictures() const { return pictures_; }

 private:
  void exchange(Instant now, pipeline::Inputs& inputs);
  void takePicture(Instant now, pipeline::Inputs& inputs);
  /// The firmware's own watchdogs: without a living command the motors are off.
  void lookAtMotors(Instant now);

  const bool own_board_;
  std::shared_ptr<std::atomic<std::int64_t>> clock_ns_ = std::make_shared<std::atomic<std::int64_t>>();
  sim::FaultPlan faults_;
  std::shared_ptr<sim::TouchpadWorld> world_;
  std::shared_ptr<sim::TouchpadElectronics> electronics_;
  std::unique_ptr<sim::ModbusTcpServer> modbus_;
  std::unique_ptr<sim::QbmoveServer> board_;
  std::unique_ptr<device::ModbusTouchpad> touchpad_;
  std::unique_ptr<device::QbmoveMotors> motors_;
  device::FrozenReadings frozen_;
  device::Plausibility plausibility_;

  control::MotorCommand command_;
  Timed<control::MotorFeedback> board_feedback_;
  Instant due_{};
  Instant board_due_{};
  Duration retry_{};
  Duration board_retry_{};
  Instant active_sent_{};   // to either
  Instant undisturbed_{};   // the last moment of a fault that silences both
  Instant silent_since_{};  // the first of the present one
  bool silent_ = false;

  sim::FaultPlan camera_faults_;
  sim::SimulatedCamera camera_;
  sensing::FingerDetector detector_;
  device::FrozenPicture same_;
  device::DamageWatch damage_;
  cv::Mat picture_;
  std::vector<std::uint8_t> jpeg_;
  std::mt19937 random_{1};
  Instant next_picture_;
  Duration picture_period_;
  std::uint64_t pictures_ = 0;
  Instant fault_ends_{};
  Instant camera_fault_ends_{};
};

}  // namespace fyd::soak
