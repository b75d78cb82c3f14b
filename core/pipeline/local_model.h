// What a finger feels of this computer, without asking a robot: a stored surface or a scene.
#pragma once

#include <memory>
#include <optional>

#include "core/texture/surface_model.h"

namespace fyd::scene {
class FeltScene;
}

namespace fyd::pipeline {

struct LocalModel {
  std::optional<texture::SurfaceModel> surface;   ///< rendered while no robot is wanted
  std::shared_ptr<const scene::FeltScene> scene;  ///< in the robot's place; a step goes on with a copy of its own
};

}  // namespace fyd::pipeline
