// A short word for what a scene feels like, the same on every machine: two copies with the same word feel the same.
#pragma once

#include <string>

#include "core/scene/loaded_scene.h"

namespace fyd::scene {

/// BLAKE2b (RFC 7693), 16 bytes in hexadecimal, of every value of the description, the meshes' vertices and triangles
/// as they are stepped, and the stored surfaces. Comments, the order of keys, names and paths do not enter.
[[nodiscard]] std::string digestOf(const LoadedScene& scene);

}  // namespace fyd::scene
