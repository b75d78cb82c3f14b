// View of a picture whose pixels are owned elsewhere: rows of 8-bit samples. The core's detector and the camera's
// threads pass this, so that neither needs the other's image library.
// Stability: may change
#pragma once

#include <cstddef>
#include <cstdint>

namespace fyd {

struct ImageView {
  const std::uint8_t* data = nullptr;  ///< first sample of the top row
  int width = 0;                       ///< px
  int height = 0;                      ///< px
  std::ptrdiff_t stride = 0;           ///< bytes from a row to the next; ±width·channels or more: rows do not overlap
  int channels = 1;                    ///< 1: grey; 3: blue, green, red

  [[nodiscard]] bool empty() const { return data == nullptr || width <= 0 || height <= 0; }
  [[nodiscard]] const std::uint8_t* row(int y) const { return data + y * stride; }
};

/// Part of a picture that is looked at, px, inside the picture.
struct RegionOfInterest {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

}  // namespace fyd
