// Meshes and scenes from files: opened here, understood in core/scene.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/scene/contact_choice.h"
#include "core/scene/scene.h"
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

/// The contact of each body: as named; where it is left open, as measured for the scene's accuracy (`choice`), or
/// vicinity without one.
struct BodyChoice {
  scene::ContactModel model = scene::ContactModel::vicinity;
  std::optional<scene::ContactChoiceReport> choice;
};
[[nodiscard]] std::vector<BodyChoice> chooseContacts(const SceneFile& file);

[[nodiscard]] scene::Scene buildScene(const SceneFile& file, const std::vector<BodyChoice>& contacts);

}  // namespace fyd::sim
