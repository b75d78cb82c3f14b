#include "core/sim/scene_arm.h"

#include "core/scene/vector.h"

namespace fyd::sim {

Result<std::unique_ptr<SceneArm>> SceneArm::open(const std::string& file, double rate_Hz) {
  auto read = openScene(file);
  if (!read) return tl::unexpected(read.error());
  const auto choices = chooseModels(*read);
  if (!choices) return fail(about(file, choices.error().message));
  auto scene = buildScene(*read, *choices);
  if (!scene) return fail(about(file, scene.error().message));
  return std::unique_ptr<SceneArm>(
      new SceneArm(std::make_shared<SceneStage>(std::move(*read)), std::move(*scene), rate_Hz));
}

SceneArm::SceneArm(std::shared_ptr<SceneStage> stage, scene::Scene scene, double rate_Hz)
    : stage_(std::move(stage)), scene_(std::move(scene)) {
  moment_.shapes_mm.resize(scene_.bodies());
  for (const auto& texture : stage_->file().textures) {
    auto& to = textures_.emplace_back();
    if (texture) to.emplace(*texture, rate_Hz);
  }
}

Message SceneArm::description() const { return say("scene {}", stage_->file().description.settings.name); }

Result<device::RobotReadings> SceneArm::exchange(const Vec3& target_mm, Instant now) {
  if (!target_mm.finite()) {
    return fail("robot target ({}, {}, {}) mm: expected three finite numbers", target_mm.x, target_mm.y, target_mm.z);
  }
  Vec3 acceleration_g;
  if (!last_ || now > *last_) {
    const double dt_s = last_ ? toSeconds(now - *last_) : 0.0;
    const Vec3 way_mm = target_mm - at_mm_;
    at_mm_ = target_mm;
    last_ = now;
    touch_ = scene_.step(target_mm, toSeconds(now.time_since_epoch()));
    acceleration_g = shaken(way_mm, dt_s);
    if (!shown_ || now - *shown_ >= kShown) {
      shown_ = now;
      show();
    }
  }
  return device::RobotReadings{.position_mm = touch_.touching ? touch_.proxy_mm : at_mm_,
                               .force_N = scene::length(touch_.force_N),
                               .acceleration_g = acceleration_g,
                               .taken = *last_,
                               .commanded_mm = at_mm_,
                               .stiffness_N_per_mm = touch_.stiffness_N_per_mm};
}

Vec3 SceneArm::shaken(const Vec3& way_mm, double dt_s) {
  if (!touch_.touching || touch_.body == scene::kNoBody || !textures_[touch_.body] || !(dt_s > 0.0)) return {};
  const Vec3 along = way_mm - scene::dot(way_mm, touch_.normal) * touch_.normal;
  return textures_[touch_.body]->step(scene::length(along) / dt_s, scene::length(touch_.force_N)) * touch_.normal;
}

void SceneArm::show() {
  moment_.stepped = true;
  moment_.time_s = scene_.time_s();
  moment_.point_mm = at_mm_;
  moment_.touch = touch_;
  moment_.swords = scene_.gestures().swords();
  moment_.ball = scene_.gestures().ball();
  for (std::size_t i = 0; i < scene_.bodies(); ++i) {
    const scene::SoftBody* soft = scene_.soft(i);
    std::vector<Vec3>& shape_mm = moment_.shapes_mm[i];
    if (soft == nullptr || (soft->awake().empty() && shape_mm.empty())) continue;
    const std::span<const Vec3> rest_mm = scene_.mesh(i).vertices();
    shape_mm.assign(rest_mm.begin(), rest_mm.end());
    for (std::uint32_t v = 0; v < shape_mm.size(); ++v) shape_mm[v] = shape_mm[v] + soft->displacement_mm(v);
  }
  stage_->show(moment_);
}

}  // namespace fyd::sim
