// One picture of curves over time: traces that share a unit. Draws from a CurveSource, one min/max pair per pixel
// column.
//
// The time axis counts from the right edge, so that scale and grid stand still while the curves move.
#pragma once

#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "widgets/curve_source.h"
#include "widgets/theme.h"
#include "widgets/time_window.h"
#include "widgets/value_range.h"

class QCustomPlot;
class QCPGraph;
class QCPItemText;
class QRubberBand;

namespace fyd::widgets {

struct Trace {
  std::size_t channel = 0;  ///< of the buffer
  Quantity quantity = Quantity::none;
  bool dashed = false;
  QString lane;  ///< not empty: the trace has a lane of its own, named so, and shares the others' scale
};

class CurveStrip : public QWidget {
  Q_OBJECT
 public:
  /// @param name for screen readers
  /// @param least range shown at least
  CurveStrip(const QString& name, const QString& unit, Range least, std::vector<Trace> traces, bool with_time_scale,
             QWidget* parent = nullptr);

  void draw(const CurveSource& source, const TimeWindow& window);
  /// Back to a vertical range that follows the data.
  void freeRange() { fixed_range_.reset(); }
  void fixRange(Range range) { fixed_range_ = range; }
  [[nodiscard]] Range shownRange() const;
  /// Largest and smallest value drawn in the last `draw`; for tests.
  [[nodiscard]] Range drawnExtent() const { return drawn_; }
  [[nodiscard]] QCustomPlot* plot() const { return plot_; }

 signals:
  void panned(double by_s);                    ///< > 0 towards the past
  void zoomed(double factor, double about_s);  ///< about_s counts from the right edge, ≤ 0
  void boxed(double from_s, double to_s);      ///< from the right edge, ≤ 0
  void followAsked();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void dress();
  void fill(QCPGraph* graph, const Trace& trace, const CurveSource& source, const TimeWindow& window);
  void buildLanes();
  [[nodiscard]] double laneCentre(std::size_t trace) const;
  [[nodiscard]] double timeAt(double x_px) const;
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  void wheel(const QWheelEvent& event);

  QCustomPlot* plot_;
  std::vector<Trace> traces_;
  ValueRange range_;
  std::optional<Range> fixed_range_;
  QString unit_;
  bool lanes_ = false;
  QCPItemText* scale_text_ = nullptr;  ///< what a lane's height means
  Range drawn_;
  std::vector<CurveColumn> columns_;
  bool with_time_scale_;
  QRubberBand* band_;
  Qt::MouseButton button_ = Qt::NoButton;
  QPointF last_;
  QPointF pressed_;
};

}  // namespace fyd::widgets
