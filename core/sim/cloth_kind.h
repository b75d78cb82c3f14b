// Which cloth is simulated, and which finger presses it.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace fyd::sim {

/// ideal: stiffness the same everywhere and at every depth, shape by the estimator's own formula.
/// membrane: four edges held, solved in finite strain. rollers: two edges held, two free.
enum class ClothKind : std::uint8_t { ideal, membrane, rollers };
inline constexpr std::array<std::string_view, 3> kClothNames{"ideal", "membrane", "rollers"};

enum class FingerShape : std::uint8_t { sphere, capsule, disc };
inline constexpr std::array<std::string_view, 3> kFingerShapeNames{"sphere", "capsule", "disc"};

}  // namespace fyd::sim
