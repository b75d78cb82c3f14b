// device::Touchpad on a simulated world, which it shares with the simulated camera.
#pragma once

#include <memory>

#include "core/device/touchpad/touchpad.h"
#include "core/sim/touchpad/touchpad_world.h"

namespace fyd::sim {

class SimulatedTouchpad final : public device::Touchpad {
 public:
  explicit SimulatedTouchpad(std::shared_ptr<TouchpadWorld> world) : world_(std::move(world)) {}

  [[nodiscard]] Message description() const override;
  /// Advances the world to `now` under the old command, reads, and gives it the new one. Never fails.
  [[nodiscard]] Result<device::TouchpadReadings> exchange(const control::MotorCommand& command, Instant now) override;
  [[nodiscard]] std::vector<device::DeviceReport> reports() const override;
  [[nodiscard]] Duration period() const override { return TouchpadWorld::kStep; }

 private:
  std::shared_ptr<TouchpadWorld> world_;
};

}  // namespace fyd::sim
