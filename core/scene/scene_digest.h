// A digest of what a scene feels like, the same on every machine: two scenes with the same digest feel the same.
#pragma once

#include <string>

#include "core/scene/loaded_scene.h"

namespace fyd::scene {

enum class SurfaceNames { left_out, hashed };

/// BLAKE2b [RFC 7693], 16 bytes in hexadecimal, of every value of the description, the meshes' vertices and triangles
/// as they are stepped, and the stored surfaces. Comments, the order of keys, names and paths have no influence; that of
/// bodies has, as of two equal forces the first is reported.
/// @param names of stored surfaces and their descriptions: hashed only for states that recordings hold, which would not
/// be known again otherwise
[[nodiscard]] std::string digestOf(const LoadedScene& scene, SurfaceNames names = SurfaceNames::left_out);

}  // namespace fyd::scene
