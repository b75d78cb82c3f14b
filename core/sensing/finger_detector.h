// Finds the finger in a picture of the cloth seen from below [thesis §4.1.1].
//
// adaptive (default): the cloth's light B(u, v) is a smooth surface fitted to the picture's own cells; a pixel's
//   darkness is d = 1 − I/B; pixels darker than half the finger's darkness D form runs, runs form connected blobs,
//   and of several blobs the one nearest the last finger is taken, without one the largest. Then, around that blob
//   only, area = Σd/D and centroid = Σd·(u, v)/Σd: sums that blur does not change.
// thesis: ROI → 160 × 120 → grey < threshold; area is the count; contact when area > minimum;
//   centroid weighted by exp(−(I−µ)²/2σ²) with µ the darkest value and σ = (max − min)/5.
//   σ = 0 is answered with flat_picture (the printed code divides by zero); position is kept while there is no contact.
//
// px → mm, adaptive: x = ±(u − u₀)·sx, y = −(v − v₀)·sy, then turned by the rotation.
// px → mm, thesis: the printed 0.46875 mm/px of the 160 × 120 picture, about its middle.
//
// Used by one thread at a time. Allocates only at the first picture and when its size changes. Never throws for
// any picture; the reason says what is wrong with one.
// Stability: may change
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/base/api.h"
#include "core/base/image.h"
#include "core/sensing/finger_parameters.h"
#include "core/sensing/finger_types.h"

namespace fyd::sensing {

class FYD_API FingerDetector {
 public:
  explicit FingerDetector(const FingerParameters& parameters = {});
  ~FingerDetector();
  FingerDetector(FingerDetector&&) noexcept;
  FingerDetector& operator=(FingerDetector&&) noexcept;

  /// Live changes; the learned light and the last finger are kept unless the region or the mode changes.
  void configure(const FingerParameters& parameters);

  /// no_picture for one without pixels, of other channels, with rows that overlap, or with too small a region.
  [[nodiscard]] FingerDetection detect(const ImageView& picture);

  /// Forgets light and last finger, as for a picture on its own.
  void reset();

  /// Region looked at in the last picture, clipped to it.
  [[nodiscard]] RegionOfInterest region() const;

  /// Draws the last picture's dark pixels: 255 for the finger's blob, 128 for other dark blobs, 0 for cloth.
  /// @param mask region().width × region().height bytes, row by row; nothing is written when it is smaller
  void drawOverlay(std::span<std::uint8_t> mask) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fyd::sensing
