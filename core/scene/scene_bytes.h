// A scene as bytes, for a recording: all that it takes to feel it again, without the files it came from.
//
// CBOR [RFC 8949], a map:
//   format    1
//   name      for people
//   text      the scene file, TOML
//   rate_Hz   of the steps
//   meshes    of each: vertices_mm, 3 × f64 a vertex, and triangles, 3 × u32 a triangle, little-endian byte strings
//   bodies    of each: mesh, index into `meshes`; texture, TOML of its stored surface or ""; and as chosen when it was
//             built: contact, and of a soft body most_points
#pragma once

#include <string>
#include <string_view>

#include "core/scene/felt_scene.h"

namespace fyd::scene {

[[nodiscard]] std::string packScene(const FeltScene& scene);

/// As it was when it was built, to the bit: not how it was touched since.
/// @return an error for bytes that are no scene, or of a format this program does not know
[[nodiscard]] Result<FeltScene> unpackScene(std::string_view bytes);

}  // namespace fyd::scene
