#include "core/scene/felt_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scene/mesh/vector.h"
#include "core/scene/scene_digest.h"
#include "core/signal/sample_rate.h"

namespace fyd::scene {

Result<FeltScene> FeltScene::build(std::shared_ptr<const LoadedScene> loaded, double rate_Hz) {
  const auto choices = chooseModels(*loaded);
  if (!choices) return tl::unexpected(choices.error());
  return build(std::move(loaded), modelsOf(*choices), rate_Hz);
}

Result<FeltScene> FeltScene::build(std::shared_ptr<const LoadedScene> loaded, std::vector<BodyModel> models,
                                   double rate_Hz) {
  if (auto checked = signal::checkSampleRate(rate_Hz); !checked) return tl::unexpected(checked.error());
  auto scene = buildScene(*loaded, models);
  if (!scene) return tl::unexpected(scene.error());
  return FeltScene(std::move(loaded), std::move(models), std::move(*scene), rate_Hz);
}

FeltScene::FeltScene(std::shared_ptr<const LoadedScene> loaded, std::vector<BodyModel> models, Scene scene,
                     double rate_Hz)
    : loaded_(std::move(loaded)),
      models_(std::move(models)),
      rate_Hz_(rate_Hz),
      digest_(digestOf(*loaded_)),
      digest_of_state_(std::ranges::any_of(loaded_->textures, [](const auto& each) { return each.has_value(); })
                           ? digestOf(*loaded_, SurfaceNames::hashed)
                           : digest_),
      scene_(std::move(scene)) {
  for (const auto& texture : loaded_->textures) {
    auto& to = textures_.emplace_back();
    if (texture) to.emplace(*texture, rate_Hz);
  }
}

const SceneTouch& FeltScene::step(const Vec3& probe_mm, double time_s) {
  if (!probe_mm.finite() || !std::isfinite(time_s)) {
    touchAt(probe_mm, time_s);
    return touch_;
  }
  const double dt_s = known_ ? time_s - time_s_ : 0.0;
  if (known_ && !(dt_s > 0.0)) {
    if (dt_s < -kSetBack_s) {
      static_cast<void>(scene_.step(probe_mm, time_s));  // sets its clock back too
      time_s_ = time_s;
    }
    texture_g_ = 0.0;
    return touch_;
  }
  known_ = true;
  time_s_ = time_s;
  const Vec3 moved_mm = probe_mm - std::exchange(probe_mm_, probe_mm);
  touchAt(probe_mm, time_s);
  if (!touch_.touching || touch_.body == kNoBody || !textures_[touch_.body] || !(dt_s > 0.0)) return touch_;
  const Vec3 slid_mm = moved_mm - dt_s * scene_.placement(touch_.body).velocity_mm_per_s;
  const Vec3 along_mm = slid_mm - dot(slid_mm, touch_.normal) * touch_.normal;
  texture_g_ = textures_[touch_.body]->step(length(along_mm) / dt_s, length(touch_.force_N));
  return touch_;
}

void FeltScene::touchAt(const Vec3& probe_mm, double time_s) {
  const std::size_t before = touch_.body;
  touch_ = scene_.step(probe_mm, time_s);
  texture_g_ = 0.0;
  // Nothing steps the texture of a body that is not touched: the next stroke would begin with the last one's vibration.
  if (before != kNoBody && touch_.body != before && textures_[before]) textures_[before]->reset();
}

}  // namespace fyd::scene
