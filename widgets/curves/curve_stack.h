// Curves one below the other on one time axis, each with its numerals: the strips that are chosen, the cursor, the
// marks A and B with the differences between them, time linked or each strip's own. The live curves and those of a
// review both use this widget; their owners provide the samples and move the time window while following.
//
// Times are seconds of the source. A time that is not finite stands for "none".
#pragma once

#include <QLabel>
#include <QWidget>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "widgets/basics/readout.h"
#include "widgets/curves/curve_source.h"
#include "widgets/curves/curve_strip.h"
#include "widgets/curves/time_window.h"

namespace fyd::widgets {

struct StripSetup {
  QString id;
  QString title;
  QString unit;
  Range least;  ///< shown at least
  std::vector<Trace> traces;
  std::vector<Readout::Entry> entries;
  std::vector<std::size_t> channels;  ///< of the source, one for each entry
  bool large = false;
  bool peak = false;  ///< its live numeral is a largest magnitude
  bool shown = true;
};

class CurveStack : public QWidget {
  Q_OBJECT
 public:
  enum class Mark { a, b };

  explicit CurveStack(TimeWindow window, QWidget* parent = nullptr);
  void add(StripSetup setup);
  /// Keeps windows that the operator moves within what there is to see; called with each after every move.
  void setBounds(std::function<void(TimeWindow&)> hold) { hold_ = std::move(hold); }

  [[nodiscard]] std::size_t size() const { return strips_.size(); }
  [[nodiscard]] const StripSetup& setup(std::size_t index) const { return strips_[index].setup; }
  [[nodiscard]] CurveStrip* strip(std::size_t index) const { return strips_[index].strip; }
  [[nodiscard]] Readout* readout(std::size_t index) const { return strips_[index].readout; }
  /// @return size() when there is none of that id
  [[nodiscard]] std::size_t indexOf(const QString& id) const;

  [[nodiscard]] bool shown(std::size_t index) const { return strips_[index].setup.shown; }
  /// At least one stays shown.
  void setShown(std::size_t index, bool shown);

  [[nodiscard]] bool linked() const { return linked_; }
  /// Linked again, all show the stretch of the strip that was moved last.
  void setLinked(bool linked);
  /// The common one while linked, else of the strip that was moved last.
  [[nodiscard]] const TimeWindow& window() const { return windows_[linked_ ? 0 : last_moved_]; }
  [[nodiscard]] const TimeWindow& window(std::size_t index) const { return windows_[linked_ ? 0 : index]; }
  /// Whether every shown strip follows.
  [[nodiscard]] bool following() const;
  /// Changes every strip's window, also while they are not linked.
  void forEachWindow(const std::function<void(TimeWindow&)>& change);
  /// The newest sample's time.
  void advance(double newest_s);

  void setCursor_s(double time_s);
  [[nodiscard]] double cursor_s() const { return cursor_s_; }
  void setMark(Mark which, double time_s);
  [[nodiscard]] double mark_s(Mark which) const { return marks_s_[static_cast<std::size_t>(which)]; }
  void clearMarks();
  /// "A 1.200 s   B 1.700 s   Δt 0.500 s   2.00 Hz"; empty without marks.
  [[nodiscard]] QString markText() const;

  /// All vertical scales stay as they are shown now, or follow the data again.
  void holdRanges(bool hold);
  /// Whether every shown strip keeps its vertical scale.
  [[nodiscard]] bool rangesHeld() const;
  void freeRanges();

  void draw(const CurveSource& source);
  /// Least time that a column of a shown strip stands for.
  [[nodiscard]] double column_s() const;
  /// Whether a strip's numerals are those at the cursor: there is one, and the strip does not follow.
  [[nodiscard]] bool readsCursor(std::size_t index) const {
    return std::isfinite(cursor_s_) && !window(index).following();
  }

 signals:
  void moved();               ///< the operator moved a window, a mark or the choice: draw again
  void clicked(double at_s);  ///< a click without dragging
  void followAsked();         ///< a double click

 private:
  struct Strip {
    StripSetup setup;
    CurveStrip* strip = nullptr;
    Readout* readout = nullptr;
    QWidget* row = nullptr;
  };
  /// The values at the cursor, beside the curves and, where the strip reads the cursor, as its numerals.
  void readCursor(std::size_t index, const CurveSource& source);
  void change(std::size_t index, const std::function<void(TimeWindow&)>& change);
  void arrange();
  /// The difference between the marks in one strip, "Δ 2.00 N", or the value at the only one; empty without marks.
  [[nodiscard]] QString markWords(std::size_t index, const CurveSource& source) const;

  std::vector<Strip> strips_;
  std::vector<TimeWindow> windows_;  ///< one for each strip; while linked only the first counts
  std::function<void(TimeWindow&)> hold_;
  std::size_t last_moved_ = 0;
  bool linked_ = true;
  double cursor_s_ = std::numeric_limits<double>::quiet_NaN();
  double marks_s_[2] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  bool marks_changed_ = true;  ///< values at the marks are read once, not with every redraw
  QLabel* mark_label_ = nullptr;
};

}  // namespace fyd::widgets
