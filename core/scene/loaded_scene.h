// A scene with all that it names: its text, the meshes and the stored surfaces.
// Stability: may change
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/api.h"
#include "core/base/error.h"
#include "core/scene/contact/contact_choice.h"
#include "core/scene/scene.h"
#include "core/scene/soft/soft_choice.h"
#include "core/texture/surface_model.h"

namespace fyd::scene {

struct LoadedScene {
  std::string text;  ///< TOML, as written
  SceneDescription description;
  std::vector<std::shared_ptr<const SearchedMesh>> meshes;     ///< of each body; those of one mesh share it
  std::vector<std::optional<texture::SurfaceModel>> textures;  ///< of each body
};

/// Whether any rigid body of the description uses a mesh: its SearchedMesh then needs `walkable`.
/// @param uses whether a body, by its place in the description, uses it: one file may be named in several ways
template <class Uses>
[[nodiscard]] bool needsWalkableMesh(const SceneDescription& description, Uses uses) {
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    if (!description.bodies[i].soft && uses(i)) return true;
  }
  return false;
}

/// What the description leaves open: chosen by trials for the scene's accuracy; vicinity and kUsualPoints without one.
struct BodyChoice {
  BodyModel model;
  std::optional<ContactChoiceReport> contact;  ///< of a rigid body, where it was chosen
  std::optional<SoftChoiceReport> soft;        ///< of a soft body, likewise
};
/// @return the error of checkMeshes, or one that names the body and what of its material is out of range
[[nodiscard]] FYD_API Result<std::vector<BodyChoice>> chooseModels(const LoadedScene& scene);

/// @return the error of Scene::build, or that there are not as many textures as bodies
[[nodiscard]] FYD_API Result<Scene> buildScene(const LoadedScene& scene, const std::vector<BodyModel>& models);
[[nodiscard]] FYD_API std::vector<BodyModel> modelsOf(const std::vector<BodyChoice>& choices);

}  // namespace fyd::scene
