// Kinds of simulated cloth and of fingers that press it.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace fyd::sim {

/// ideal: the same stiffness at every place and depth, shape by the estimator's own formula.
/// membrane: four edges held. rollers: held left and right by the rollers, front and back free. Both solved in finite
/// strain.
enum class ClothKind : std::uint8_t { ideal, membrane, rollers };
inline constexpr std::array<std::string_view, 3> kClothNames{"ideal", "membrane", "rollers"};

/// What presses a membrane or a cloth between rollers. sphere: 8 mm of radius; capsule: the same, 30 mm long, tilted by
/// 30° towards the user; disc: flat, 7 mm.
enum class FingerKind : std::uint8_t { sphere, capsule, disc };
inline constexpr std::array<std::string_view, 3> kFingerNames{"sphere", "capsule", "disc"};

}  // namespace fyd::sim
