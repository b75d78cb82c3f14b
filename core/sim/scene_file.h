// Meshes and scenes from files: opened here, understood in core/scene.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/scene/contact_choice.h"
#include "core/scene/scene.h"
#include "core/scene/soft_choice.h"
#include "core/texture/surface_model.h"

namespace fyd::sim {

/// @return an error that names the file: not there, no regular file, too large, no mesh
[[nodiscard]] Result<scene::Mesh> openMesh(const std::string& path, scene::LengthUnit unit);

/// A scene file with its meshes. Bodies of the same file and unit share one mesh.
struct SceneFile {
  scene::SceneDescription description;
  std::vector<std::shared_ptr<const scene::SearchedMesh>> meshes;  ///< of each body
  std::vector<std::optional<texture::SurfaceModel>> textures;      ///< of each body
};

/// @return an error that names the file, and the line or the mesh
[[nodiscard]] Result<SceneFile> openScene(const std::string& path);

/// What the description leaves open: as measured for the scene's accuracy, or vicinity and as many points as a press
/// wakes without one.
struct BodyChoice {
  scene::BodyModel model;
  std::optional<scene::ContactChoiceReport> contact;  ///< of a rigid body, where it was chosen
  std::optional<scene::SoftChoiceReport> soft;        ///< of a soft body, likewise
};
[[nodiscard]] Result<std::vector<BodyChoice>> chooseModels(const SceneFile& file);

[[nodiscard]] Result<scene::Scene> buildScene(const SceneFile& file, const std::vector<BodyChoice>& choices);

}  // namespace fyd::sim
