// A scene as a finger feels it, step by step: the touch, and the vibration of a finger that slides over what it
// touches.
//
// Frame: the robot's, whose origin is the scene's. A body with a stored surface adds a vibration along its normal, from
// the speed at which the point slides over the body, which may fly itself, and the force
// (core/texture/virtual_texture.h). Each touch of a body begins in silence.
//
// A copy starts where the original is and shares what does not change: meshes, trees and what contact models prepare.
// Stability: may change
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "core/scene/loaded_scene.h"
#include "core/texture/virtual_texture.h"

namespace fyd::scene {

class FYD_API FeltScene {
 public:
  /// Models as measured (chooseModels). @param loaded not null
  /// @param rate_Hz of the steps. @return an error that names the body, or what of the scene or the rate cannot be
  [[nodiscard]] static Result<FeltScene> build(std::shared_ptr<const LoadedScene> loaded, double rate_Hz);
  [[nodiscard]] static Result<FeltScene> build(std::shared_ptr<const LoadedScene> loaded, std::vector<BodyModel> models,
                                               double rate_Hz);

  /// As Scene::step; allocates nothing. Where no time passes nothing vibrates.
  const SceneTouch& step(const Vec3& probe_mm, double time_s);

  /// Of the last step.
  [[nodiscard]] const SceneTouch& touch() const { return touch_; }
  /// Acceleration of the finger along the touch's normal, g.
  [[nodiscard]] double texture_g() const { return texture_g_; }
  [[nodiscard]] const Vec3& probe_mm() const { return probe_mm_; }
  [[nodiscard]] const Scene& scene() const { return scene_; }

  [[nodiscard]] const std::shared_ptr<const LoadedScene>& loaded() const { return loaded_; }
  [[nodiscard]] const std::vector<BodyModel>& models() const { return models_; }
  [[nodiscard]] double rate_Hz() const { return rate_Hz_; }
  /// Of what is felt: two scenes with the same digest feel the same.
  [[nodiscard]] const std::string& digest() const { return digest_; }
  /// The same with the names of stored surfaces, for a saved state.
  [[nodiscard]] const std::string& digestOfState() const { return digest_of_state_; }

  /// All that the next steps depend on.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(scene_, probe_mm_, time_s_, known_, touch_, texture_g_);
    if (touch_.body != kNoBody && touch_.body >= textures_.size()) throw std::out_of_range("no such body");
    for (std::optional<texture::VirtualTexture>& texture : textures_) {
      if (texture) archive(*texture);
    }
  }

 private:
  void touchAt(const Vec3& probe_mm, double time_s);

  FeltScene(std::shared_ptr<const LoadedScene> loaded, std::vector<BodyModel> models, Scene scene, double rate_Hz);

  std::shared_ptr<const LoadedScene> loaded_;
  std::vector<BodyModel> models_;
  double rate_Hz_;
  std::string digest_, digest_of_state_;
  Scene scene_;
  std::vector<std::optional<texture::VirtualTexture>> textures_;  // of each body
  Vec3 probe_mm_;
  double time_s_ = 0.0;
  bool known_ = false;
  SceneTouch touch_;
  double texture_g_ = 0.0;
};

}  // namespace fyd::scene
