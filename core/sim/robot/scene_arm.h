// A haptic scene in the place of a robot: the tool is the haptic point itself. It follows each target at once and has
// no mass; the bodies it touches push back.
#pragma once

#include "core/device/robot/robot.h"
#include "core/scene/felt_scene.h"

namespace fyd::sim {

class SceneArm final : public device::Robot {
 public:
  /// @param rate_Hz of the exchanges
  [[nodiscard]] static Result<std::unique_ptr<SceneArm>> open(const std::string& file, double rate_Hz);

  [[nodiscard]] Message description() const override;
  [[nodiscard]] bool inVirtualTime() const override { return true; }
  /// Accepted without effect: nothing with mass moves.
  bool keepLimits(const device::MotionLimits& /*limits*/) override { return true; }

  /// If `now` did not increase, the last touch is returned again.
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
