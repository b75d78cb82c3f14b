// A digest of what a scene feels like, the same on every machine: two scenes with the same digest feel the same.
#pragma once

#include <string>

#include "core/scene/loaded_scene.h"

namespace fyd::scene {

/// BLAKE2b [RFC 7693], 16 bytes in hexadecimal, of every value of the description, the meshes' vertices and triangles
/// as they are stepped, and the stored surfaces. Comments, key order, names and paths have no influence.
[[nodiscard]] std::string digestOf(const LoadedScene& scene);

}  // namespace fyd::scene
