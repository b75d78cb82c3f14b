// Result of the finger detector for one picture [thesis §4.1.1].
// Stability: stable since 0.1
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

#include "core/base/api.h"
#include "core/base/fields.h"

namespace fyd::sensing {

/// Stored in files by number: numbers never change, and a new one takes the next.
enum class FingerReason : std::uint8_t {
  found = 0,           ///< a finger, all is well
  no_finger = 1,       ///< the picture is good and shows none
  too_small = 2,       ///< something dark, smaller than the minimum area
  at_edge = 3,         ///< a finger, cut by the edge of the region of interest
  several = 4,         ///< several blobs; the one nearest the last finger was taken
  flat_picture = 5,    ///< darkest and brightest pixel are equal: nothing to weigh
  black_picture = 6,   ///< no light
  saturated = 7,       ///< (nearly) every pixel at the top of the scale
  blurred = 8,         ///< edge too soft for the usual accuracy
  no_picture = 9,      ///< empty, or the region of interest lies outside it
  light_unknown = 10,  ///< no light of the cloth can be told from what lies on it: it may show anything
};

/// Whether the picture shows the cloth, so that "no contact" means that nothing touches it.
[[nodiscard]] constexpr bool showsCloth(FingerReason reason) {
  using enum FingerReason;
  return reason != black_picture && reason != saturated && reason != flat_picture && reason != no_picture &&
         reason != light_unknown;
}

/// A word or two for the operator and for JSON, such as "at edge".
[[nodiscard]] FYD_API std::string_view toString(FingerReason reason);

struct FingerDetection {
  bool contact = false;
  double area_px = 0.0;
  double area_mm2 = std::numeric_limits<double>::quiet_NaN();
  double x_px = 0.0;
  double y_px = 0.0;
  double x_mm = 0.0;
  double y_mm = 0.0;
  double quality = 0.0;
  FingerReason reason = FingerReason::no_picture;

  static constexpr auto fields() {
    using F = FingerDetection;
    return std::tuple(
        Field("area_px", "px", "of the camera's picture (thesis mode: of its 160 × 120 picture); also without contact",
              &F::area_px),
        Field("area_mm2", "mm²",
              "the same on the untouched cloth's plane, by the camera's scale; none where the picture shows no cloth",
              &F::area_mm2),
        Field("x_px", "px", "centroid in the camera's full picture, x right; without contact 0 (thesis mode: the last)",
              &F::x_px),
        Field("y_px", "px", "centroid in the camera's full picture, y down; without contact 0 (thesis mode: the last)",
              &F::y_px),
        Field("x_mm", "mm", "in the touchpad's frame, x right; without contact 0 (thesis mode: the last)", &F::x_mm),
        Field("y_mm", "mm", "in the touchpad's frame, y back; without contact 0 (thesis mode: the last)", &F::y_mm),
        Field("quality", "1", "0 useless … 1 as good as it gets", &F::quality),
        Field("contact", "1", "1: a finger presses the cloth; the position is meaningful only then", &F::contact),
        Field("reason", "1", "FingerReason: why there is a finger or none", &F::reason));
  }
};

}  // namespace fyd::sensing
