// The tables of resources/cloths, built into the library: the simulation opens no file.
#pragma once

#include <string_view>

namespace fyd::sim {

/// @param name without its ending, e.g. "frame_sphere8". @return empty when there is none
[[nodiscard]] std::string_view clothTableText(std::string_view name);

}  // namespace fyd::sim
