#include "core/scene/scene_stage.h"

namespace fyd::scene {

SceneStage::SceneStage(std::shared_ptr<const LoadedScene> scene) : scene_(std::move(scene)) {
  for (const BodyDescription& body : scene_->description.bodies) placements_.emplace_back(body);
  moment_.shapes_mm.resize(placements_.size());
}

void SceneStage::show(const FeltScene& felt) {
  const Scene& scene = felt.scene();
  if (moment_.stepped && scene.time_s() - moment_.time_s < kPublishPeriod_s) return;
  moment_.stepped = true;
  moment_.time_s = scene.time_s();
  moment_.point_mm = felt.probe_mm();
  moment_.touch = felt.touch();
  moment_.swords = scene.gestures().swords();
  moment_.ball = scene.gestures().ball();
  for (std::size_t i = 0; i < scene.bodies(); ++i) {
    const SoftBody* soft = scene.soft(i);
    std::vector<Vec3>& shape_mm = moment_.shapes_mm[i];
    if (soft == nullptr || (soft->awake().empty() && shape_mm.empty())) continue;
    const std::span<const Vec3> rest_mm = scene.mesh(i).vertices();
    shape_mm.assign(rest_mm.begin(), rest_mm.end());
    for (std::uint32_t v = 0; v < shape_mm.size(); ++v) shape_mm[v] = shape_mm[v] + soft->displacement_mm(v);
  }
  show(moment_);
}

}  // namespace fyd::scene
