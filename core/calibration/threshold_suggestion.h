// A grey threshold between cloth and finger, from the histogram of a picture with a finger on the cloth.
//
// Otsu's threshold (the split with the largest variance between the two sides), then the emptiest grey value between
// the two sides' means, because a small finger pulls Otsu's split into the cloth.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/message.h"

namespace fyd::calibration {

struct ThresholdSuggestion {
  bool plausible = false;
  int threshold = 0;          ///< grey values below it are the finger, as sensing.finger_threshold
  double finger_grey = 0.0;   ///< mean of the darker side
  double cloth_grey = 0.0;    ///< mean of the brighter side
  double finger_share = 0.0;  ///< of all pixels
  double separation = 0.0;    ///< difference of the means over the wider side's standard deviation
  Message reason;             ///< when not plausible: cause and what to do
};

[[nodiscard]] ThresholdSuggestion suggestThreshold(const std::array<std::uint64_t, 256>& histogram);

}  // namespace fyd::calibration
