// Meshes and scenes from files: opened here, parsed in core/scene.
#pragma once

#include <string>

#include "core/scene/felt_scene.h"

namespace fyd::sim {

/// @return an error that names the file: not there, no regular file, too large, no mesh
[[nodiscard]] Result<scene::Mesh> openMesh(const std::string& path, scene::LengthUnit unit);

/// @param given a file, or the name of a scene that comes with the programs
/// @return an error that names the file, and the line or the mesh
[[nodiscard]] Result<scene::LoadedScene> openScene(const std::string& given);
/// Ready to be stepped. @return an error that names the file, and the line, the mesh or the body
[[nodiscard]] Result<scene::FeltScene> openFeltScene(const std::string& path, double rate_Hz);

}  // namespace fyd::sim
