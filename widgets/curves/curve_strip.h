// One plot of curves over time: traces that share a unit. Draws from a CurveSource, one min/max pair per
// column.
//
// The time axis counts from the right edge, so that scale and grid stay in place while the curves move. While a window
// follows, its numbers are seconds before now; else they are the session's time.
#pragma once

#include <QString>
#include <QWidget>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "widgets/basics/theme.h"
#include "widgets/curves/curve_source.h"
#include "widgets/curves/time_window.h"
#include "widgets/curves/value_range.h"

class QCustomPlot;
class QCPGraph;
class QCPItemStraightLine;
class QCPPainter;
class QCPItemText;
class QRubberBand;

namespace fyd::widgets {

class CurvePlot;
class PlotLabels;
class LevelScale;

enum class Stroke {
  solid,
  dashed,  ///< a target
  dotted,  ///< the reachable target, or a replay with other parameters
  faint    ///< another session, for comparison
};

struct Trace {
  std::size_t channel = 0;  ///< of the source
  Quantity quantity = Quantity::none;
  Stroke stroke = Stroke::solid;
  QString lane;  ///< not empty: the trace has a lane of its own, named so, and shares the others' scale
  QString word;  ///< before its value at the cursor; empty: the strip's own quantity
  int decimals = 2;
};

/// A moment marked in the plot by a vertical line.
struct TimeMark {
  double time_s = 0.0;
  QString name;  ///< at the foot of the line; empty: none
  bool strong = false;
};

class CurveStrip : public QWidget {
  Q_OBJECT
 public:
  /// @param name for screen readers
  /// @param least range shown at least
  CurveStrip(const QString& name, const QString& unit, Range least, std::vector<Trace> traces, bool with_time_scale,
             QWidget* parent = nullptr);
  ~CurveStrip() override;

  void draw(const CurveSource& source, const TimeWindow& window);
  /// Columns of samples across the plot.
  [[nodiscard]] std::size_t columns() const;
  /// Paints what the last `draw` drew, for an export to a file.
  void paintTo(QCPPainter& painter, QSize size);
  void setTimeScale(bool shown);
  /// Drawn with the next `draw`.
  void setMarks(std::vector<TimeMark> marks) { marks_ = std::move(marks); }
  /// Drawn with the next `draw`, beside the curves. @param time_s not finite: none
  /// @param values one for each trace; NaN: none
  void setCursorValues(double time_s, std::vector<double> values);
  [[nodiscard]] const PlotLabels& labels() const { return *labels_; }
  /// Text about the marks, in the corner; empty: none.
  void setMarkWords(const QString& words);
  [[nodiscard]] QString markWords() const;
  /// Limit values, drawn as lines across the plot; not in lanes.
  void setLimits(const std::vector<double>& limits);
  /// The limits that are drawn.
  [[nodiscard]] std::vector<double> limits() const;
  /// Back from a stretched or boxed range to the chosen one, or to one that follows the data.
  void freeRange() { fixed_range_.reset(); }
  void fixRange(Range range) { fixed_range_ = range; }
  /// The operator's choice; none: the range follows the data.
  void chooseRange(std::optional<Range> range);
  [[nodiscard]] const std::optional<Range>& chosenRange() const { return chosen_range_; }
  [[nodiscard]] Range shownRange() const;
  /// Largest and smallest value drawn in the last `draw`; for tests.
  [[nodiscard]] Range drawnExtent() const { return drawn_; }
  [[nodiscard]] QCustomPlot* plot() const;

 signals:
  void panned(double by_s);                    ///< > 0 towards the past
  void zoomed(double factor, double about_s);  ///< about_s counts from the right edge, ≤ 0
  void boxed(double from_s, double to_s);      ///< from the right edge, ≤ 0
  void stretched();                            ///< vertically; time goes on as before
  void followAsked();
  void clicked(double at_s);  ///< without dragging; from the right edge, ≤ 0

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void dress();
  void fill(QCPGraph* graph, const Trace& trace, const CurveSource& source, const TimeWindow& window);
  void buildLanes();
  void drawMarks(const TimeWindow& window);
  void drawLabels(const TimeWindow& window);
  /// A trace's value on the value axis.
  [[nodiscard]] double heightOf(std::size_t trace, double value) const;
  [[nodiscard]] Range baseRange() const { return chosen_range_.value_or(range_.shown()); }
  [[nodiscard]] double laneCentre(std::size_t trace) const;
  /// The value at the edge of a lane.
  [[nodiscard]] double laneHeight() const;
  [[nodiscard]] double timeAt(double x_px) const;
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  void wheel(const QWheelEvent& event);

  CurvePlot* plot_ = nullptr;
  std::vector<Trace> traces_;
  ValueRange range_;
  bool drew_live_ = false;  ///< the last picture followed
  std::optional<Range> fixed_range_;
  std::optional<Range> chosen_range_;
  QString unit_;
  bool lanes_ = false;
  QCPItemText* scale_text_ = nullptr;  ///< the value range of a lane's height
  Range drawn_;
  std::vector<CurveColumn> columns_;
  std::vector<TimeMark> marks_;
  std::vector<QCPItemStraightLine*> mark_lines_;  ///< as many as were ever needed; spare ones are hidden
  QCPItemText* mark_words_ = nullptr;
  std::vector<QCPItemStraightLine*> limit_lines_;
  std::unique_ptr<LevelScale> time_scale_;
  PlotLabels* labels_ = nullptr;  ///< the plot owns it
  double cursor_s_ = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> cursor_values_;
  QRubberBand* band_ = nullptr;
  Qt::MouseButton button_ = Qt::NoButton;
  bool dragged_ = false;  ///< the press became a drag
  QPointF last_;
  QPointF pressed_;
};

}  // namespace fyd::widgets
