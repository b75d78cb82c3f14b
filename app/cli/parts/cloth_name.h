// The simulated cloth by its name on the command line.
#pragma once

#include <algorithm>
#include <string_view>

#include "core/sim/cloth_kind.h"

namespace fyd::cli {

/// @param name one of sim::kClothNames
[[nodiscard]] inline sim::ClothKind clothOf(std::string_view name) {
  return static_cast<sim::ClothKind>(std::ranges::find(sim::kClothNames, name) - sim::kClothNames.begin());
}

}  // namespace fyd::cli
