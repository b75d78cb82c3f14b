#include "core/sim/simulated_touchpad.h"

namespace fyd::sim {

std::string SimulatedTouchpad::description() const {
  return fmt::format("simulated touchpad, seed {}", world_->parameters().seed);
}

Result<device::TouchpadReadings> SimulatedTouchpad::exchange(const control::MotorCommand& command, Instant now) {
  world_->advanceTo(now);
  world_->command(command);
  return world_->readings();
}

}  // namespace fyd::sim
