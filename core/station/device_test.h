// Runs a device test on an operator's held button, on the haptic loop and only while nothing else may move a motor.
//
// It runs in Connected, Ready and Stopped. It ends by itself, and by: the button's release or 0.5 s without `keep`,
// any stop or arm, any change of the safety state, a motor board that falls silent, 20 ms without a step, a motor
// 10° away from where it was sent. Only the next press starts it again. A sweep relies on neither the zero nor the
// sign of an encoder: from its first step on, a motor must turn as far as commanded, in either direction.
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "core/control/control_parameters.h"
#include "core/device/touchpad/test_motion.h"
#include "core/pipeline/inputs.h"
#include "core/pipeline/outputs.h"
#include "core/station/sweep_tape.h"

namespace fyd::station {

/// The state of the device test, for the operator's display.
struct DeviceTestStatus {
  bool running = false;
  device::DeviceTest test = device::DeviceTest::motor_1;     ///< the last one asked for
  double progress = 0.0;                                     ///< 0…1
  bool finished = false;                                     ///< the last one came to its end
  Message words;                                             ///< "running", or how the last one ended; empty before it
  std::array<double, control::kMotorCount> commanded_deg{};  ///< where the motors are sent; of the running one
  bool resting = false;                                      ///< the command has not changed for 0.3 s
};

class DeviceTestRunner {
 public:
  static constexpr Duration kHold = std::chrono::milliseconds(500);  ///< longest time between two calls of `keep`

  // the operator's thread
  /// @param stretch_deg where `stretch` and `chirp` go, within control.travel_minimum_deg and travel_maximum_deg
  /// @return an error when it may not run now; a test that is running is ended by it
  [[nodiscard]] Result<void> start(device::DeviceTest test, Instant now, double stretch_deg = 0.0);
  /// The button is still held.
  void keep(Instant now) { kept_.store(now.time_since_epoch().count(), std::memory_order_relaxed); }
  void stop() { request_.store(0, std::memory_order_release); }
  [[nodiscard]] DeviceTestStatus status() const;
  /// Rows measured by breakaway and chirp. To be called several times a second while they run, and once shortly after.
  [[nodiscard]] std::vector<texture::SweepRow> sweep() {
    tape_.gather();
    return tape_.rows();
  }

  // the haptic loop
  /// @param outputs of the step for these inputs
  /// @return what goes to the motors in place of the step's command; nothing: no test runs
  [[nodiscard]] std::optional<control::MotorCommand> step(const pipeline::Inputs& inputs,
                                                          const pipeline::Outputs& outputs,
                                                          const control::ControlParameters& parameters);

 private:
  enum class End : std::uint8_t {
    none,
    running,
    finished,
    released,
    operator_acted,
    state_changed,
    motors_silent,
    steps_missing,
    off_course,
    not_now,
    beyond_limit,
    beyond_travel,
    beyond_motors,
  };
  [[nodiscard]] static Message words(End end);
  [[nodiscard]] static End refusal(const pipeline::Inputs& inputs, const pipeline::Outputs& outputs);
  [[nodiscard]] End check(const pipeline::Inputs& inputs, const pipeline::Outputs& outputs,
                          const std::array<double, control::kMotorCount>& motor_deg) const;
  [[nodiscard]] bool follows(Duration elapsed, const std::array<double, control::kMotorCount>& motor_deg) const;
  void begin(const pipeline::Inputs& inputs, const pipeline::Outputs& outputs,
             const control::ControlParameters& parameters, const std::array<double, control::kMotorCount>& motor_deg);
  void end(End why);

  // between threads
  std::atomic<std::uint32_t> request_{0};  // 0: none; else number of the press, the test in the low byte
  std::atomic<std::int64_t> kept_{0};      // ns of the clock
  std::atomic<End> refused_now_{End::not_now};
  std::atomic<std::uint64_t> outcome_{0};  // number of the press above, End in the low byte
  std::atomic<double> progress_{0.0};
  std::atomic<double> wanted_stretch_deg_{0.0};  // of the press above
  std::array<std::atomic<double>, control::kMotorCount> commanded_deg_{};
  std::atomic<bool> resting_{false};
  SweepTape tape_;

  // the operator's
  std::uint32_t presses_ = 0;
  std::uint32_t asked_ = 0;

  // the loop's
  std::uint32_t seen_ = 0;  // the last request it took up
  std::optional<device::TestMotion> motion_;
  std::array<double, control::kMotorCount> swept_from_deg_{};  // encoder angles at the sweep's first rest
  Instant started_{};
  Instant last_step_{};
  pipeline::SafetyState state_ = pipeline::SafetyState::disconnected;
};

}  // namespace fyd::station
