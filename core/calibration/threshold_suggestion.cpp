#include "core/calibration/threshold_suggestion.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace fyd::calibration {
namespace {

constexpr double kLeastSeparation = 3.0;
constexpr double kLeastContrast = 20.0;                          // grey values
constexpr double kSmallestFinger = 0.002, kLargestFinger = 0.5;  // share of the picture

struct Side {
  double count = 0.0, mean = 0.0, sigma = 0.0;
};

Side sideOf(const std::array<std::uint64_t, 256>& histogram, int from, int to) {
  Side side;
  double sum = 0.0;
  for (int grey = from; grey < to; ++grey) {
    const auto n = static_cast<double>(histogram[static_cast<std::size_t>(grey)]);
    side.count += n;
    sum += n * grey;
  }
  if (side.count == 0) return side;
  side.mean = sum / side.count;
  double squares = 0.0;
  for (int grey = from; grey < to; ++grey) {
    squares += static_cast<double>(histogram[static_cast<std::size_t>(grey)]) * (grey - side.mean) * (grey - side.mean);
  }
  side.sigma = std::sqrt(squares / side.count);
  return side;
}

}  // namespace

ThresholdSuggestion suggestThreshold(const std::array<std::uint64_t, 256>& histogram) {
  ThresholdSuggestion out;
  int split = 0;
  double best = 0.0;
  for (int t = 1; t < 256; ++t) {
    const Side dark = sideOf(histogram, 0, t), bright = sideOf(histogram, t, 256);
    const double between = dark.count * bright.count * (dark.mean - bright.mean) * (dark.mean - bright.mean);
    if (between > best) {
      best = between;
      split = t;
    }
  }
  if (split == 0) {
    out.reason = say("the picture has one grey value only: check the camera and the light");
    return out;
  }
  const Side dark = sideOf(histogram, 0, split), bright = sideOf(histogram, split, 256);
  // The valley: fewest pixels in a window of five; of a wide empty valley the middle.
  const int from = static_cast<int>(std::ceil(dark.mean)), to = static_cast<int>(std::floor(bright.mean));
  const auto around = [&](int grey) {
    std::uint64_t sum = 0;
    for (int i = std::max(0, grey - 2); i <= std::min(255, grey + 2); ++i)
      sum += histogram[static_cast<std::size_t>(i)];
    return sum;
  };
  int first = split, last = split;
  std::uint64_t least = around(split);
  for (int grey = from; grey <= to; ++grey) {
    const std::uint64_t here = around(grey);
    if (here < least) {
      least = here;
      first = grey;
    }
    if (here == least) last = grey;
  }
  out.threshold = std::clamp((std::min(first, last) + std::max(first, last)) / 2, 1, 255);
  const Side finger = sideOf(histogram, 0, out.threshold), cloth = sideOf(histogram, out.threshold, 256);
  out.finger_grey = finger.mean;
  out.cloth_grey = cloth.mean;
  out.finger_share = finger.count / (finger.count + cloth.count);
  out.separation = (cloth.mean - finger.mean) / std::max({finger.sigma, cloth.sigma, 1.0});
  if (out.separation < kLeastSeparation || cloth.mean - finger.mean < kLeastContrast) {
    out.reason =
        say("finger ({:.0f}) and cloth ({:.0f}) are not told apart: put a finger on the cloth, or more light behind it",
            finger.mean, cloth.mean);
  } else if (out.finger_share < kSmallestFinger || out.finger_share > kLargestFinger) {
    out.reason = say("{:.1f} % of the picture is dark; a finger takes {:.1f} to {:.0f} %: check the region of interest",
                     100 * out.finger_share, 100 * kSmallestFinger, 100 * kLargestFinger);
  } else {
    out.plausible = true;
  }
  return out;
}

}  // namespace fyd::calibration
