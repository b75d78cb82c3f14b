// A scene where a robot stands: the tool is the haptic point itself, so it is where it is told to be, at once, without
// weight, and what it touches pushes back.
//
// Frame: the robot's, whose origin is the scene's. Bodies' textures shake the tool as a finger that slides over them:
// from its speed along the surface and the force (core/texture/virtual_texture.h), across the surface.
#pragma once

#include "core/device/robot.h"
#include "core/sim/scene_stage.h"
#include "core/texture/virtual_texture.h"

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

  [[nodiscard]] const scene::SceneTouch& touch() const { return touch_; }
  /// Shown there: each step that is kShown or more after the one shown before.
  [[nodiscard]] const std::shared_ptr<SceneStage>& stage() const { return stage_; }
  static constexpr Duration kShown = std::chrono::milliseconds(16);

 private:
  SceneArm(std::shared_ptr<SceneStage> stage, scene::Scene scene, double rate_Hz);
  [[nodiscard]] Vec3 shaken(const Vec3& way_mm, double dt_s);
  void show();

  std::shared_ptr<SceneStage> stage_;
  scene::Scene scene_;
  std::vector<std::optional<texture::VirtualTexture>> textures_;
  scene::SceneTouch touch_;
  Vec3 at_mm_;
  std::optional<Instant> last_;
  std::optional<Instant> shown_;
  SceneMoment moment_;
};

}  // namespace fyd::sim
