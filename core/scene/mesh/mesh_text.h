// A mesh out of the bytes of an OBJ, STL or PLY file (text and binary), read by CGAL in double.
// Stability: stable since 0.1
#pragma once

#include <string_view>

#include "core/base/api.h"
#include "core/scene/mesh/mesh.h"

namespace fyd::scene {

enum class MeshFormat : std::uint8_t { obj, stl, ply };
inline constexpr std::array<std::string_view, 3> kMeshFormats = {"obj", "stl", "ply"};

enum class LengthUnit : std::uint8_t { mm, cm, m, in };
inline constexpr std::array<std::string_view, 4> kLengthUnits = {"mm", "cm", "m", "in"};
[[nodiscard]] FYD_API double millimetresPer(LengthUnit unit);

/// By the name's extension, case-insensitive. @return an error with the formats when it is none of them
[[nodiscard]] FYD_API Result<MeshFormat> meshFormatOf(std::string_view file_name);

/// Polygons are cut into triangles. Normals, colours, groups and materials are ignored; no other file is opened.
/// @return an error when the bytes are not of this format
[[nodiscard]] FYD_API Result<TriangleSoup> parseMesh(std::string_view bytes, MeshFormat format, LengthUnit unit);

}  // namespace fyd::scene
