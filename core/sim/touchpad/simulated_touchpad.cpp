#include "core/sim/touchpad/simulated_touchpad.h"

#include "core/device/touchpad/reading_values.h"

namespace fyd::sim {

Message SimulatedTouchpad::description() const { return say("simulated touchpad, seed {}", world_->parameters().seed); }

Result<device::TouchpadReadings> SimulatedTouchpad::exchange(const control::MotorCommand& command, Instant now) {
  world_->advanceTo(now);
  world_->command(command);
  return world_->readings();
}

std::vector<device::DeviceReport> SimulatedTouchpad::reports() const {
  device::DeviceReport out{.kind = say("simulated"), .description = description()};
  const device::TouchpadReadings readings = world_->readings();
  addSensorValues(readings, out.values);
  addMotorValues(readings.motors, out.values);
  return {std::move(out)};
}

}  // namespace fyd::sim
