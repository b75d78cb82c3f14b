// Error-against-cost diagram for the manual, as SVG.
#pragma once

#include <string>
#include <vector>

namespace fyd::bench {

struct CostPoint {
  std::string name;
  double cost = 0.0;  ///< ns, or a multiple of the baseline's
  double error = 0.0;
};
struct CostPanel {
  std::string title;
  std::vector<CostPoint> points;
};

/// Cost to the right, logarithmic; error upward.
struct CostAxes {
  double least = 5.0, most = 2000.0;
  bool ratio = false;          ///< costs are multiples of the baseline's, not ns
  std::vector<double> errors;  ///< lines, ascending; the first and the last are the ends
  double marked_error = 0.0;   ///< a darker line
  bool logarithmic = false;    ///< errors; the first is then above 0
  std::string unit;            ///< after each error
  std::string marked;          ///< point in red
};

/// SVG with the panels side by side.
[[nodiscard]] std::string errorAgainstCost(const std::vector<CostPanel>& panels, const CostAxes& axes);

}  // namespace fyd::bench
