#include "core/sim/robot/scene_arm.h"

#include "core/scene/mesh/vector.h"
#include "core/sim/scene_file.h"

namespace fyd::sim {

Result<std::unique_ptr<SceneArm>> SceneArm::open(const std::string& file, double rate_Hz) {
  auto scene = openFeltScene(file, rate_Hz);
  if (!scene) return tl::unexpected(scene.error());
  return std::unique_ptr<SceneArm>(new SceneArm(std::move(*scene)));
}

Message SceneArm::description() const { return say("scene {}", scene_.loaded()->description.settings.name); }

Result<device::RobotReadings> SceneArm::exchange(const Vec3& target_mm, Instant now) {
  if (!target_mm.finite()) {
    return fail("robot target ({}, {}, {}) mm: expected three finite numbers", target_mm.x, target_mm.y, target_mm.z);
  }
  Vec3 acceleration_g;
  if (!last_ || now > *last_) {
    last_ = now;
    const scene::SceneTouch& touch = scene_.step(target_mm, toSeconds(now.time_since_epoch()));
    acceleration_g = scene_.texture_g() * touch.normal;
  }
  const scene::SceneTouch& touch = scene_.touch();
  return device::RobotReadings{.position_mm = touch.touching ? touch.proxy_mm : scene_.probe_mm(),
                               .force_N = scene::length(touch.force_N),
                               .acceleration_g = acceleration_g,
                               .taken = *last_,
                               .commanded_mm = scene_.probe_mm(),
                               .stiffness_N_per_mm = touch.stiffness_N_per_mm};
}

}  // namespace fyd::sim
