// What a finger feels without a robot, computed on this machine: a stored surface or a scene.
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
  std::optional<texture::SurfaceModel> surface;   ///< rendered while no robot is wanted
  std::shared_ptr<const scene::FeltScene> scene;  ///< replaces the robot; each pipeline works on a copy of its own
};

}  // namespace fyd::pipeline
