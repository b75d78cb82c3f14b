// The simulated cloth by its name on the command line, and those on which the benches of indentation and controller run.
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "core/sim/cloth_kind.h"

namespace fyd::bench {

/// @param name one of sim::kClothNames
[[nodiscard]] inline sim::ClothKind clothOf(std::string_view name) {
  return static_cast<sim::ClothKind>(std::ranges::find(sim::kClothNames, name) - sim::kClothNames.begin());
}

/// In the tables' order.
inline std::vector<sim::ClothKind>& benchCloths() {
  static std::vector<sim::ClothKind> cloths{sim::ClothKind::membrane, sim::ClothKind::rollers, sim::ClothKind::ideal};
  return cloths;
}

}  // namespace fyd::bench
