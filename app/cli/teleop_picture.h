// The table of fyd teleop as a picture: a block of bars for each network and period.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fyd::cli {

struct TeleopPanel {
  std::string network;
  double period_ms = 0.0;
  std::vector<std::pair<std::string, double>> rms_mm;  ///< predictor and pooled RMS error
};

/// SVG: a row a network, a column a period; a bar a predictor, its length the RMS error by the longest of the block.
[[nodiscard]] std::string teleopPicture(const std::vector<TeleopPanel>& panels);

}  // namespace fyd::cli
