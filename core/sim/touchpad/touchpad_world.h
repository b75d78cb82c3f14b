// The one physical state behind the simulated touchpad and its camera: finger, cloth, motors, sensors.
//
// It runs in virtual time on a fixed grid of 1 ms from its start, advanced by the first caller that needs a later time
// (the device thread or the camera thread); the result depends only on the seed, the finger and the commands' instants.
// A jump of more than 200 ms is not simulated in full: the world skips to 200 ms before the new time.
// Thread-safe: every public function locks.
#pragma once

#include <array>
#include <mutex>
#include <optional>
#include <random>
#include <vector>

#include "core/base/time.h"
#include "core/control/motor_types.h"
#include "core/device/touchpad/touchpad.h"
#include "core/sim/cloth/cloth.h"
#include "core/sim/finger_path.h"
#include "core/sim/sim_parameters.h"
#include "core/sim/touchpad/finger_vibration.h"
#include "core/sim/touchpad/simulated_motor.h"

namespace fyd::sim {

/// The true state at one instant, without sensor errors.
struct WorldSnapshot {
  Instant taken{};
  FingerState finger;
  double angle_deg = 0.0;           ///< stretch, half the difference of the two motors
  double stiffness_N_per_mm = 0.0;  ///< of the cloth at that angle, under that finger, without hysteresis
  double force_N = 0.0;             ///< of the finger on the cloth
  double contact_area_mm2 = 0.0;    ///< of the contact, seen from straight below
  double contact_x_mm = 0.0;        ///< its centre, on the cloth
  double contact_y_mm = 0.0;
  double felt_g = 0.0;  ///< acceleration that the vibration gives the finger; 0 without one
  std::array<double, control::kMotorCount> motor_deg{};
};

class TouchpadWorld {
 public:
  /// @param start the world's time 0, and that of the finger's path
  TouchpadWorld(const SimParameters& parameters, FingerPath path, Instant start);

  static constexpr Duration kStep = std::chrono::milliseconds(1);
  static constexpr Duration kLongestCatchUp = std::chrono::milliseconds(200);
  static constexpr Duration kHistory = std::chrono::milliseconds(2000);

  /// A time earlier than the last has no effect.
  void advanceTo(Instant now);

  /// Valid from the world's present time on. A duty that is not a number counts as 0; references beyond the travel are
  /// followed to the end stops.
  void command(const control::MotorCommand& command);

  /// The sensors' last readings, each with its own instant.
  [[nodiscard]] device::TouchpadReadings readings() const;

  /// The state at an instant of the last 2 s, linear between grid points; before and after them the nearest known one.
  [[nodiscard]] WorldSnapshot truthAt(Instant when) const;
  [[nodiscard]] WorldSnapshot truth() const;

  /// Puts the finger somewhere (a mouse, a test) in place of the path; nullopt gives it back to the path.
  /// Clamped to the usable area; NaN lifts.
  void setFingerOverride(std::optional<FingerState> finger);
  /// Another path in place of the present one, from its beginning.
  void setPath(FingerPath path);

  [[nodiscard]] const SimParameters& parameters() const { return parameters_; }

 private:
  void skip(Duration gap);
  void step();
  void sense();
  void senseIr();
  void senseBridge();
  void senseMotors();
  void remember();
  [[nodiscard]] FingerState fingerNow() const;
  [[nodiscard]] WorldSnapshot lookBack(double delay_ms) const;
  [[nodiscard]] WorldSnapshot truthLocked(Instant when) const;
  [[nodiscard]] double gaussian(double sigma);

  const SimParameters parameters_;
  mutable std::mutex mutex_;
  FingerPath path_;
  Instant path_begins_;  ///< its time 0
  std::optional<FingerState> finger_override_;
  Cloth cloth_;
  FingerVibration vibration_;
  double vibration_g_ = 0.0;
  std::array<SimulatedMotor, control::kMotorCount> motors_;
  control::MotorCommand command_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  Instant now_;
  Instant pressed_;
  Instant next_ir_;
  Instant next_bridge_;
  device::TouchpadReadings readings_;
  std::vector<WorldSnapshot> history_;  // ring, newest at (written_ − 1)
  std::size_t written_ = 0;
};

}  // namespace fyd::sim
