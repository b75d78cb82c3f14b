// The electronics between the simulated world and the servers of its interfaces: the registers' firmware, the motor
// board, motor temperatures, power and faults. One state, shared by all servers. Thread-safe: every function locks.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

#include "core/sim/server/motor_board.h"
#include "core/sim/server/register_bank.h"
#include "core/sim/server/touchpad_fault.h"
#include "core/sim/touchpad/touchpad_world.h"

namespace fyd::sim {

class TouchpadElectronics {
 public:
  TouchpadElectronics(std::shared_ptr<TouchpadWorld> world, FaultPlan faults, const MotorBoardOptions& board,
                      Instant start, RegisterBank bank = RegisterBank());

  /// The time by which the servers answer: the system's, unless another was given before they started.
  [[nodiscard]] Instant clock() const { return clock_(); }
  void readTimeFrom(std::function<Instant()> clock) { clock_ = std::move(clock); }

  /// Advances the world to `now`, a millisecond at a time, each with its own vibration duty. Each server calls it
  /// before it answers; the process calls it every few milliseconds besides.
  void advanceTo(Instant now);

  /// False during a brown-out: nothing answers.
  [[nodiscard]] bool powered(Instant now) const { return !faults_.active(TouchpadFault::brown_out, now); }

  /// Whether the answer to a request received now comes late.
  [[nodiscard]] bool answersLate(Instant now);

  [[nodiscard]] ModbusException write(int master, int address, std::span<const std::uint16_t> values, Instant now);
  void fill(RegisterBank::Image& image, int master, Instant now);
  void forget(int master);
  [[nodiscard]] std::optional<protocol::QbmoveFrame> handle(const protocol::QbmoveFrame& frame, Instant now);

  [[nodiscard]] const FaultPlan& faults() const { return faults_; }
  [[nodiscard]] TouchpadWorld& world() { return *world_; }

  struct Figures {
    std::uint64_t modbus_requests = 0;
    std::uint64_t refused_writes = 0;
    std::uint64_t motor_board_frames = 0;
    std::uint64_t restarts = 0;
    double motors_on_s = 0.0;
    double vibration_peak_percent = 0.0;
    protocol::DriveState drive = protocol::DriveState::not_ready_to_switch_on;
    protocol::DriveFault fault = protocol::DriveFault::none;
    bool motors_on = false;
    std::array<double, control::kMotorCount> temperature_degC{};
  };
  [[nodiscard]] Figures figures() const;

 private:
  void step(Instant now);
  void warm(double seconds);
  [[nodiscard]] device::TouchpadReadings sensed(Instant now);

  const std::shared_ptr<TouchpadWorld> world_;
  const FaultPlan faults_;
  std::function<Instant()> clock_ = [] { return Clock::now(); };
  mutable std::mutex mutex_;
  RegisterBank bank_;
  MotorBoard board_;
  Instant now_;
  int brown_outs_ = 0;
  int late_replies_ = 0;
  Figures figures_;
  std::optional<std::uint16_t> stuck_code_;
  std::optional<device::TouchpadReadings> frozen_;
};

}  // namespace fyd::sim
