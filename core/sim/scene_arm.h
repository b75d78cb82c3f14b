// A scene where a robot stands: the tool is the haptic point itself, so it is where it is told to be, at once, without
// weight, and what it touches pushes back.
#pragma once

#include "core/device/robot.h"
#include "core/scene/felt_scene.h"

namespace fyd::sim {

class SceneArm final : public device::Robot {
 public:
  /// @param rate_Hz of the exchanges
  [[nodiscard]] static Result<std::unique_ptr<SceneArm>> open(const std::string& file, double rate_Hz);

  [[nodiscard]] Message description() const override;
  [[nodiscard]] bool inVirtualTime() const override { return true; }
  /// Nothing moves that would need them.
  bool keepLimits(const device::MotionLimits& /*limits*/) override { return true; }

  /// Time that stands still or goes back gives the last touch again.
  /// @return an error when the target is not finite
  [[nodiscard]] Result<device::RobotReadings> exchange(const Vec3& target_mm, Instant now) override;

  [[nodiscard]] const std::string& digest() const { return scene_.digest(); }
  [[nodiscard]] const scene::SceneTouch& touch() const { return scene_.touch(); }

 private:
  explicit SceneArm(scene::FeltScene scene) : scene_(std::move(scene)) {}

  scene::FeltScene scene_;
  std::optional<Instant> last_;
};

}  // namespace fyd::sim
