// Checks in the drawn pixels whether a spike of one sample is visible.
#pragma once

#include <QColor>

class QCustomPlot;

namespace fyd::widgets {
class CurveView;
}

namespace fyd::console::bench {

/// Whether a pixel near where the spike's tip must be has the curve's full colour.
/// @param share of the plot's width, 0 at its left edge
[[nodiscard]] bool spikeSeen(QCustomPlot& plot, double share, double value, const QColor& colour);

struct SpikeCount {
  int shown = 0;  ///< spikes within the shown time
  int lost = 0;
};
/// All samples of `value` in the first of the live curves.
[[nodiscard]] SpikeCount countSpikes(const widgets::CurveView& view, float value);

}  // namespace fyd::console::bench
