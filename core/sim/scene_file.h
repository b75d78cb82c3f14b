// Meshes and scenes from files: opened here, understood in core/scene.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/scene/mesh.h"
#include "core/scene/mesh_text.h"

namespace fyd::sim {

/// @return an error that names the file: not there, no regular file, too large, no mesh
[[nodiscard]] Result<scene::Mesh> openMesh(const std::string& path, scene::LengthUnit unit);

}  // namespace fyd::sim
