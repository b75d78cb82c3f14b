#include "core/scene/scene_stage.h"

namespace fyd::scene {

SceneStage::SceneStage(std::shared_ptr<const LoadedScene> scene) : scene_(std::move(scene)) {
  std::size_t soft_points = 0;
  for (std::size_t i = 0; i < scene_->description.bodies.size(); ++i) {
    const BodyDescription& body = scene_->description.bodies[i];
    placements_.emplace_back(body);
    if (body.soft) soft_points += scene_->meshes[i]->mesh.vertices().size();
  }
  shown_.shapes_mm.resize(placements_.size());
  drawn_.reserve(soft_points);
  // Written and read in turn, each slot gets the room of every point: from then on a write allocates nothing.
  next_.points.resize(soft_points);
  for (int slot = 0; slot < 3; ++slot) {
    published_.write(next_);
    static_cast<void>(published_.read());
  }
  next_.points.clear();
  published_.write(next_);
}

void SceneStage::show(const SceneMoment& moment) {
  next_.moment = moment;
  next_.moment.shapes_mm.clear();
  next_.points.clear();
  published_.write(next_);
}

void SceneStage::show(const FeltScene& felt) {
  const Scene& scene = felt.scene();
  SceneMoment& moment = next_.moment;
  if (moment.stepped && scene.time_s() - moment.time_s < kPublishPeriod_s) return;
  moment.stepped = true;
  moment.time_s = scene.time_s();
  moment.point_mm = felt.probe_mm();
  moment.touch = felt.touch();
  moment.swords = scene.gestures().swords();
  moment.ball = scene.gestures().ball();
  next_.points.clear();
  for (std::size_t i = 0; i < scene.bodies(); ++i) {
    const SoftBody* soft = scene.soft(i);
    if (soft == nullptr) continue;
    for (const std::uint32_t v : soft->awake()) {
      next_.points.push_back({static_cast<std::uint32_t>(i), v, soft->displacement_mm(v)});
    }
  }
  published_.write(next_);
}

const SceneMoment& SceneStage::newest() {
  const Published& now = published_.read();
  const auto rest_mm = [this](std::size_t body) { return scene_->meshes[body]->mesh.vertices(); };
  std::vector<std::vector<Vec3>> shapes_mm = std::move(shown_.shapes_mm);
  shown_ = now.moment;
  for (const Displaced& point : drawn_) shapes_mm[point.body][point.vertex] = rest_mm(point.body)[point.vertex];
  drawn_ = now.points;
  for (const Displaced& point : drawn_) {
    std::vector<Vec3>& shape_mm = shapes_mm[point.body];
    if (shape_mm.empty()) shape_mm.assign(rest_mm(point.body).begin(), rest_mm(point.body).end());
    shape_mm[point.vertex] = rest_mm(point.body)[point.vertex] + point.by_mm;
  }
  shown_.shapes_mm = std::move(shapes_mm);
  return shown_;
}

}  // namespace fyd::scene
