// What the tele-gesture paper's three gestures (swords, ball, palpation) share: the check of parameters against their
// ranges, the refusal of a step's input, the normal force of a contact, and the line segment that shows a force.
// Stability: may change
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "core/base/error.h"
#include "core/base/parameter.h"
#include "core/scene/mesh/vector.h"

namespace fyd::scene {

/// Limits of a time step. A step outside of them is refused (Refusal::no_time).
inline constexpr double kShortestStep_s = 1e-6, kLongestStep_s = 1.0;

/// Why a step moved nothing and gave no force.
enum class Refusal : std::uint8_t { none, not_a_number, too_far, no_time };
[[nodiscard]] constexpr std::string_view toString(Refusal refusal) {
  switch (refusal) {
    case Refusal::none: return "";
    case Refusal::not_a_number: return sentence("the step's input is not a number");
    case Refusal::too_far: return sentence("the step's input is farther away than 1e9 mm");
    case Refusal::no_time: return sentence("the time step is not between 1e-6 s and 1 s");
  }
  return "";
}
[[nodiscard]] inline Refusal refusalOf(const Vec3& v) {
  if (!v.finite()) return Refusal::not_a_number;
  const bool near = std::abs(v.x) <= kFarthest_mm && std::abs(v.y) <= kFarthest_mm && std::abs(v.z) <= kFarthest_mm;
  return near ? Refusal::none : Refusal::too_far;
}
[[nodiscard]] inline Refusal refusalOf(double dt_s) {
  return dt_s >= kShortestStep_s && dt_s <= kLongestStep_s ? Refusal::none : Refusal::no_time;
}
/// The first input's refusal that is not `none`.
template <class... Inputs>
[[nodiscard]] Refusal firstRefusal(const Inputs&... inputs) {
  Refusal out = Refusal::none;
  static_cast<void>(((out = refusalOf(inputs), out != Refusal::none) || ...));
  return out;
}

/// @return an error that names the first parameter out of its range, its value and the range
template <class Parameters>
[[nodiscard]] Result<void> checkParameters(Parameters parameters) {
  for (const Parameter& each : bindParameters(parameters)) {
    if (!each.isNumber()) continue;
    if (const auto checked = checkParameter(each, each.value()); !checked) return tl::unexpected(checked.error());
  }
  return {};
}

/// Spring and damper, N: it begins at 0, never pulls, and dissipates energy.
/// @param rate_mm_per_s at which the depth grows. The damper's force is limited to the spring's, so that the sum is
///        continuous where a contact begins and ends.
[[nodiscard]] inline double normalForce(double depth_mm, double rate_mm_per_s, double stiffness_N_per_mm,
                                        double damping_Ns_per_mm, double most_N) {
  const double spring = stiffness_N_per_mm * std::max(0.0, depth_mm);
  return std::min(most_N, spring + std::clamp(damping_Ns_per_mm * rate_mm_per_s, -spring, spring));
}

/// The paper's green segment: a force as a line to draw.
struct ForceSegment {
  Vec3 from_mm, to_mm;
  double value_N = 0.0;
};
[[nodiscard]] inline ForceSegment forceSegment(const Vec3& at_mm, const Vec3& force_N, double mm_per_N) {
  return {at_mm, at_mm + mm_per_N * force_N, length(force_N)};
}

}  // namespace fyd::scene
