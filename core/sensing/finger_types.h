// What the finger detector says of one picture (thesis §4.1.1).
#pragma once

#include <cstdint>
#include <string_view>

namespace fyd::sensing {

/// The numbers are what a file holds: they stay, and a new one takes the next.
enum class FingerReason : std::uint8_t {
  found = 0,          ///< a finger, all is well
  no_finger = 1,      ///< the picture is good and shows none
  too_small = 2,      ///< something dark, smaller than the minimum area
  at_edge = 3,        ///< a finger, cut by the edge of the region of interest
  several = 4,        ///< several blobs; the one nearest the last was taken
  flat_picture = 5,   ///< darkest and brightest pixel are equal: nothing to weigh
  black_picture = 6,  ///< no light
  saturated = 7,      ///< (nearly) every pixel at the top of the scale
  blurred = 8,        ///< edge too soft for the usual accuracy
  no_picture = 9,     ///< empty, or the region of interest lies outside it
};

/// Whether the picture shows the cloth, so that "no contact" means that nothing touches it.
[[nodiscard]] constexpr bool showsCloth(FingerReason reason) {
  using enum FingerReason;
  return reason != black_picture && reason != saturated && reason != flat_picture && reason != no_picture;
}

/// A word or two for the operator and for JSON, such as "at edge".
[[nodiscard]] std::string_view toString(FingerReason reason);

struct FingerDetection {
  bool contact = false;  ///< a finger presses the cloth; position below is meaningful only then
  double area_px =
      0.0;  ///< px of the camera's picture; thesis mode: of its 160 × 120 picture, as printed; also without contact
  double x_px = 0.0;     ///< centroid, px in the camera's full picture, x right
  double y_px = 0.0;     ///< centroid, px in the camera's full picture, y down
  double x_mm = 0.0;     ///< touchpad frame: x right
  double y_mm = 0.0;     ///< touchpad frame: y back
  double quality = 0.0;  ///< 0 useless … 1 as good as it gets
  FingerReason reason = FingerReason::no_picture;
};

}  // namespace fyd::sensing
