// The couplings of two devices by name, and the functions that make their ends.
// Stability: may change
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>

#include "core/base/api.h"
#include "core/base/error.h"
#include "core/teleop/coupling/coupling.h"

namespace fyd::teleop {

enum class CouplingChoice : std::uint8_t { spring, tdpa, model };
inline constexpr std::array<std::string_view, 3> kCouplingNames = {"spring", "tdpa", "model"};
/// @return an error with the names when there is none of that name
[[nodiscard]] FYD_API Result<CouplingChoice> couplingNamed(std::string_view name);

[[nodiscard]] FYD_API std::unique_ptr<CouplingEnd> makeHandEnd(CouplingChoice choice, const CouplingSettings& settings);
[[nodiscard]] FYD_API std::unique_ptr<CouplingEnd> makeFarEnd(CouplingChoice choice, const CouplingSettings& settings);

}  // namespace fyd::teleop
