// The table of fyd teleop as an SVG diagram: a block of bars for each network and period.
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

/// SVG: one row per network, one column per period, one bar per predictor; lengths are RMS errors relative to the
/// block's largest.
[[nodiscard]] std::string teleopPicture(const std::vector<TeleopPanel>& panels);

}  // namespace fyd::cli
