// The simulated cloths on which the benches of indentation and controller run.
#pragma once

#include <vector>

#include "core/sim/cloth_kind.h"

namespace fyd::bench {

/// In the tables' order.
inline std::vector<sim::ClothKind>& benchCloths() {
  static std::vector<sim::ClothKind> cloths{sim::ClothKind::membrane, sim::ClothKind::rollers, sim::ClothKind::ideal};
  return cloths;
}

}  // namespace fyd::bench
