#include "core/sim/scene_arm.h"

#include "core/scene/vector.h"

namespace fyd::sim {

Result<std::unique_ptr<SceneArm>> SceneArm::open(const std::string& file, double rate_Hz) {
  const auto read = openScene(file);
  if (!read) return tl::unexpected(read.error());
  const auto choices = chooseModels(*read);
  if (!choices) return fail(about(file, choices.error().message));
  auto scene = buildScene(*read, *choices);
  if (!scene) return fail(about(file, scene.error().message));
  return std::unique_ptr<SceneArm>(new SceneArm(*read, std::move(*scene), rate_Hz));
}

SceneArm::SceneArm(const SceneFile& file, scene::Scene scene, double rate_Hz)
    : name_(file.description.settings.name), scene_(std::move(scene)) {
  for (const auto& texture : file.textures) {
    auto& to = textures_.emplace_back();
    if (texture) to.emplace(*texture, rate_Hz);
  }
}

Message SceneArm::description() const { return say("scene {}", name_); }

Result<device::RobotReadings> SceneArm::exchange(const Vec3& target_mm, Instant now) {
  if (!target_mm.finite()) {
    return fail("robot target ({}, {}, {}) mm: expected three finite numbers", target_mm.x, target_mm.y, target_mm.z);
  }
  Vec3 acceleration_g;
  if (!last_ || now > *last_) {
    const double dt_s = last_ ? toSeconds(now - *last_) : 0.0;
    before_mm_ = last_ ? at_mm_ : target_mm;
    at_mm_ = target_mm;
    last_ = now;
    touch_ = scene_.step(target_mm, toSeconds(now.time_since_epoch()));
    acceleration_g = shaken(dt_s);
  }
  return device::RobotReadings{.position_mm = touch_.touching ? touch_.proxy_mm : at_mm_,
                               .force_N = scene::length(touch_.force_N),
                               .acceleration_g = acceleration_g,
                               .taken = *last_,
                               .commanded_mm = at_mm_,
                               .stiffness_N_per_mm = touch_.stiffness_N_per_mm};
}

Vec3 SceneArm::shaken(double dt_s) {
  if (!touch_.touching || touch_.body == scene::kNoBody || !textures_[touch_.body] || !(dt_s > 0.0)) return {};
  const Vec3 way = at_mm_ - before_mm_;
  const Vec3 along = way - scene::dot(way, touch_.normal) * touch_.normal;
  return textures_[touch_.body]->step(scene::length(along) / dt_s, scene::length(touch_.force_N)) * touch_.normal;
}

}  // namespace fyd::sim
