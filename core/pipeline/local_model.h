// What a finger feels without a robot, computed on this machine: a stored surface or a scene (core/scene/felt_scene.h).
// Stability: may change
#pragma once

#include <memory>
#include <optional>

#include "core/texture/surface_model.h"

namespace fyd::scene {
class FeltScene;
}

namespace fyd::pipeline {

struct LocalModel {
  std::optional<texture::SurfaceModel> surface;  ///< rendered while no robot is wanted
  /// Replaces the robot; each pipeline works on a copy of its own. @pre its rate_Hz() is texture.sample_rate_Hz of the
  /// pipeline's parameters, the rate of the steps: at another its textures have wrong frequencies
  std::shared_ptr<const scene::FeltScene> scene;
};

}  // namespace fyd::pipeline
