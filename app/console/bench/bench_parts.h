// The parts of the window's bench. Each runs in a process of its own, so that a display's scale can be set and nothing
// of one part is warm for the next; each gives rows of the one table.
#pragma once

#include <QString>
#include <algorithm>
#include <string>
#include <vector>

namespace fyd::console::bench {

/// What was measured, of what, with what result. NaN: does not apply.
struct Row {
  std::string what;
  std::string scale;
  double p50 = 0.0;
  double p95 = 0.0;
  double worst = 0.0;
  std::string unit = "ms";
  std::string aim;
  std::string error;  ///< what the picture got wrong; empty: nothing can be
};

struct Settings {
  double seconds = 10.0;  ///< of measuring at full load
  double hours = 0.25;    ///< simulated in the soak
};

/// The whole window at full load: frames, share of the core, the way of the stop key, age of what is shown.
[[nodiscard]] std::vector<Row> frameRows(const Settings& settings);
/// The same curves given to QCustomPlot as they are.
[[nodiscard]] std::vector<Row> naiveFrameRows(const Settings& settings);
/// Moving about in a curve of ten million samples, and the same done by QCustomPlot alone.
[[nodiscard]] std::vector<Row> zoomRows(const Settings& settings);
/// The view of a scene of 1 k to 1 M triangles.
[[nodiscard]] std::vector<Row> sceneRows(const Settings& settings);
/// From the start of the process to the first curve of a simulated session on the screen.
[[nodiscard]] std::vector<Row> startRows(const Settings& settings);
/// Hours of samples through the live curves.
[[nodiscard]] std::vector<Row> soakRows(const Settings& settings);

/// Fills p50, p95 and worst. @param values reordered
inline Row& summarise(Row& row, std::vector<double> values) {
  if (values.empty()) return row;
  std::ranges::sort(values);
  const auto at = [&](double q) {
    return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
  };
  row.p50 = at(0.5);
  row.p95 = at(0.95);
  row.worst = values.back();
  return row;
}

/// "100 %".
[[nodiscard]] std::string scaleWord();
[[nodiscard]] double threadCpu_ms();
[[nodiscard]] double now_ms();  ///< of a clock that only rises

}  // namespace fyd::console::bench
