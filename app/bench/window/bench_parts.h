// The parts of the window's bench. Each runs in its own process, so that a display scale can be set and every part
// starts with cold caches; each gives rows of one table.
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
  std::string error;     ///< what was drawn wrong; empty: not applicable
  std::string compared;  ///< rows with the same word here are compared with the baseline among them
};

struct Settings {
  double seconds = 10.0;  ///< of measuring at full load
  double hours = 0.25;    ///< simulated in the soak
  std::string recording;  ///< that is opened in `blocks`; empty: none is
};

/// The whole window at full load: frame times, processor load, latency of the stop key, age of the shown data.
[[nodiscard]] std::vector<Row> frameRows(const Settings& settings);
/// The same curves drawn by QCustomPlot without decimation.
[[nodiscard]] std::vector<Row> naiveFrameRows(const Settings& settings);
/// Panning and zooming in a curve of ten million samples, and the same with QCustomPlot alone.
[[nodiscard]] std::vector<Row> zoomRows(const Settings& settings);
/// The view of a scene of 1 k to 1 M triangles.
[[nodiscard]] std::vector<Row> sceneRows(const Settings& settings);
/// From the start of the process to the first curve of a simulated session on the screen.
[[nodiscard]] std::vector<Row> startRows(const Settings& settings);
/// The longest silences of the window's thread.
[[nodiscard]] std::vector<Row> blockRows(const Settings& settings);
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
[[nodiscard]] double now_ms();  ///< of a monotonic clock

}  // namespace fyd::console::bench
