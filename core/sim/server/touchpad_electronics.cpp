#include "core/sim/server/touchpad_electronics.h"

#include <algorithm>
#include <cmath>

namespace fyd::sim {
namespace {

constexpr Duration kStep = std::chrono::milliseconds(1);
constexpr std::uint16_t kEncoderJump_counts = 512;
constexpr std::uint16_t kEncoderMask = 0x0FFF;
constexpr double kBridgeEnd_mV_per_V = 7.77;
constexpr double kNoTemperature_degC = 3276.7;  // 0x7FFF

// A small brushed motor's winding, one thermal mass: C dT/dt = I²R − (T − T₀)/Rth.
constexpr double kAmbient_degC = 23.0;
constexpr double kWinding_Ohm = 5.0;
constexpr double kThermal_K_per_W = 15.0;
constexpr double kThermalTime_s = 40.0;

}  // namespace

TouchpadElectronics::TouchpadElectronics(std::shared_ptr<TouchpadWorld> world, FaultPlan faults,
                                         const MotorBoardOptions& board, Instant start, RegisterBank bank)
    : world_(std::move(world)), faults_(std::move(faults)), bank_(std::move(bank)), board_(board), now_(start) {
  bank_.restart(start, protocol::DriveFault::none);
  figures_.temperature_degC.fill(kAmbient_degC);
}

void TouchpadElectronics::advanceTo(Instant now) {
  const std::scoped_lock lock(mutex_);
  if (now - now_ > TouchpadWorld::kLongestCatchUp) now_ = now - TouchpadWorld::kLongestCatchUp;
  while (now - now_ >= kStep) step(now_ + kStep);
}

void TouchpadElectronics::step(Instant now) {
  now_ = now;
  if (const int begun = faults_.begun(TouchpadFault::brown_out, now); begun != brown_outs_) {
    brown_outs_ = begun;
    ++figures_.restarts;
    bank_.restart(now, protocol::DriveFault::undervoltage);
    board_.restart();
  }
  if (!powered(now)) bank_.restart(now, protocol::DriveFault::undervoltage);  // the clock counts from power-up
  bank_.supervise(now, figures_.temperature_degC);
  board_.supervise(now);
  // The motors are connected to both boards here: the motor board's command counts while it is active.
  const control::MotorCommand command = board_.command().active ? board_.command() : bank_.commandAt(now);
  world_->command(command);
  world_->advanceTo(now);
  warm(toSeconds(kStep));
  figures_.motors_on = command.active;
  if (command.active) figures_.motors_on_s += toSeconds(kStep);
  for (const double duty : command.vibration_duty_percent) {
    figures_.vibration_peak_percent = std::max(figures_.vibration_peak_percent, std::abs(duty));
  }
}

void TouchpadElectronics::warm(double seconds) {
  const auto currents = world_->readings().motors.value.current_mA;
  for (std::size_t i = 0; i < currents.size(); ++i) {
    const double current_A = currents[i] / 1e3;
    const double settled = kAmbient_degC + kThermal_K_per_W * kWinding_Ohm * current_A * current_A;
    figures_.temperature_degC[i] += (settled - figures_.temperature_degC[i]) * seconds / kThermalTime_s;
  }
}

device::TouchpadReadings TouchpadElectronics::sensed(Instant now) {
  device::TouchpadReadings out = world_->readings();
  if (!faults_.active(TouchpadFault::stuck_sensor, now)) {
    stuck_code_.reset();
  } else if (!out.ir.value.empty()) {
    if (!stuck_code_) stuck_code_ = out.ir.value[0];
    out.ir.value[0] = *stuck_code_;
  }
  if (faults_.active(TouchpadFault::encoder_jump, now)) {
    std::uint16_t& counts = out.motors.value.encoder_counts[0];
    counts = static_cast<std::uint16_t>((counts + kEncoderJump_counts) & kEncoderMask);
  }
  if (faults_.active(TouchpadFault::bridge_end, now)) out.bridge.value.value_mV_per_V = kBridgeEnd_mV_per_V;
  if (!faults_.active(TouchpadFault::frozen_values, now)) {
    frozen_.reset();
  } else {
    if (!frozen_) frozen_ = out;
    out.ir.value = frozen_->ir.value;
    out.bridge.value = frozen_->bridge.value;
    out.motors.value = frozen_->motors.value;
  }
  return out;
}

bool TouchpadElectronics::answersLate(Instant now) {
  const std::scoped_lock lock(mutex_);
  const int begun = faults_.begun(TouchpadFault::late_reply, now, FaultPlan::Count::without_duration);
  const bool one_more = begun > late_replies_;
  late_replies_ = begun;
  return one_more || faults_.active(TouchpadFault::late_reply, now);
}

ModbusException TouchpadElectronics::write(int master, int address, std::span<const std::uint16_t> values,
                                           Instant now) {
  const std::scoped_lock lock(mutex_);
  return bank_.write(master, address, values, now, !faults_.active(TouchpadFault::disobedience, now));
}

void TouchpadElectronics::fill(RegisterBank::Image& image, int master, Instant now) {
  const std::scoped_lock lock(mutex_);
  bank_.fill(image, master, sensed(now), now);
  if (faults_.active(TouchpadFault::hot_reading, now)) {
    image[protocol::addressOf("temperature_1")] = static_cast<std::uint16_t>(std::lround(kNoTemperature_degC * 10.0));
  }
  ++figures_.modbus_requests;
}

void TouchpadElectronics::forget(int master) {
  const std::scoped_lock lock(mutex_);
  bank_.forget(master);
}

std::optional<protocol::QbmoveFrame> TouchpadElectronics::handle(const protocol::QbmoveFrame& frame, Instant now) {
  const std::scoped_lock lock(mutex_);
  ++figures_.motor_board_frames;
  std::array<double, control::kMotorCount> angle_deg = world_->truth().motor_deg;
  if (faults_.active(TouchpadFault::encoder_jump, now)) {
    angle_deg[0] += kEncoderJump_counts / control::kEncoderCountsPerDegree;
  }
  return board_.handle(frame, angle_deg, world_->readings().motors.value.current_mA, now);
}

TouchpadElectronics::Figures TouchpadElectronics::figures() const {
  const std::scoped_lock lock(mutex_);
  Figures out = figures_;
  out.refused_writes = bank_.refusedWrites();
  out.drive = bank_.drive().state();
  out.fault = bank_.drive().fault();
  return out;
}

}  // namespace fyd::sim
