// Error against cost of each predictor as a picture for the manual.
#pragma once

#include <string>
#include <vector>

namespace fyd::bench {

struct PredictorPoint {
  std::string name;
  double ns = 0.0;        ///< a step and axis
  double relative = 0.0;  ///< RMS error by the best of the paper's three
};
struct PredictorPanel {
  std::string title;
  std::vector<PredictorPoint> points;
};

/// SVG: a panel beside the other, cost to the right (logarithmic), error upward.
[[nodiscard]] std::string errorAgainstCost(const std::vector<PredictorPanel>& panels);

}  // namespace fyd::bench
