// Which cloth is simulated.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace fyd::sim {

/// ideal: stiffness the same everywhere and at every depth, shape by the estimator's own formula.
/// membrane: four edges held, pressed by a sphere of 8 mm, solved in finite strain.
enum class ClothKind : std::uint8_t { ideal, membrane };
inline constexpr std::array<std::string_view, 2> kClothNames{"ideal", "membrane"};

}  // namespace fyd::sim
