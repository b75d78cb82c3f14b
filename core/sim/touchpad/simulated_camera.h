// device::Camera that draws the simulated world.
#pragma once

#include <memory>
#include <random>

#include "core/device/camera/camera.h"
#include "core/sim/touchpad/picture.h"
#include "core/sim/touchpad/touchpad_world.h"

namespace fyd::sim {

class SimulatedCamera final : public device::Camera {
 public:
  /// @param clock_waits everything is simulated: the session's clock waits for a camera that is late
  explicit SimulatedCamera(std::shared_ptr<TouchpadWorld> world, bool clock_waits = false);

  [[nodiscard]] Message description() const override;
  [[nodiscard]] Message kind() const override { return say("simulated"); }

  /// Sleeps until the next picture is due, advances the world to it and draws it.
  /// Pictures that became due while the caller was busy are skipped, as with a real camera. Never fails.
  [[nodiscard]] Result<device::CameraFrame> next() override;

  /// The picture at a moment of virtual time, without waiting and without advancing the world.
  [[nodiscard]] device::CameraFrame frameAt(Instant when);

 private:
  std::shared_ptr<TouchpadWorld> world_;
  PictureRenderer renderer_;
  Duration period_;
  Duration delay_;
  std::mt19937_64 random_;
  Instant due_{};
  std::uint64_t number_ = 0;
  ClockHold hold_;
};

}  // namespace fyd::sim
