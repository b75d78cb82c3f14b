// The live curves of a session: a stack of strips on a buffer of the newest minutes, the bar above them, following.
//
// Samples may come at any rate; curves are drawn at most 30 times a second, numerals 8 times.
#pragma once

#include <QButtonGroup>
#include <QElapsedTimer>
#include <QLabel>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <span>
#include <vector>

#include "core/pipeline/telemetry.h"
#include "widgets/basics/time_field.h"
#include "widgets/curves/curve_buffer.h"
#include "widgets/curves/curve_stack.h"
#include "widgets/curves/recent_value.h"

namespace fyd::widgets {

class CurveView : public QWidget {
  Q_OBJECT
 public:
  explicit CurveView(QWidget* parent = nullptr);

  void append(std::span<const pipeline::TelemetrySample> samples);
  /// Another session begins: the curves, cursor and marks of the former one go, and the next sample is at 0 s.
  void restart();
  [[nodiscard]] bool following() const { return stack_->following(); }
  [[nodiscard]] const TimeWindow& timeWindow() const { return stack_->window(); }
  [[nodiscard]] const CurveBuffer& buffer() const { return buffer_; }
  [[nodiscard]] CurveStack* stack() const { return stack_; }
  [[nodiscard]] CurveStrip* strip(std::size_t index) const { return stack_->strip(index); }
  [[nodiscard]] Readout* readout(std::size_t index) const { return stack_->readout(index); }
  [[nodiscard]] QString followText() const { return follow_label_->text(); }
  [[nodiscard]] TimeField* timeField() const { return time_field_; }
  /// In the bar, before the lengths of the window.
  void addButton(QToolButton* button);

 public slots:
  void follow();
  void pause();
  void togglePause();
  void chooseSpan(double span_s);
  /// At the cursor, without one at the newest value.
  void setMark(CurveStack::Mark which);
  void clearMarks();  ///< and the cursor
  /// Looks back: the cursor goes there, in the middle of what is shown.
  void goTo(double time_s);
  /// @param by_s > 0 towards the newest; without a cursor it appears at the newest value
  void moveCursor(double by_s);
  /// Draws at once; for tests, exports and the bench.
  void redraw();

 signals:
  void followingChanged(bool following);
  void drawn();  ///< the curves were drawn with all samples appended so far

 private:
  void buildBar(class QVBoxLayout* layout);
  void addStrips();
  /// With less than a column of new samples the picture would be the same.
  void redrawWhenMoved();
  void refreshNumerals();
  /// Why a strip's numeral is old or missing; empty: it is current.
  [[nodiscard]] QString noteOf(const QString& strip) const;
  void sayFollowing();

  CurveBuffer buffer_;
  CurveStack* stack_ = nullptr;
  std::vector<RecentValue> recent_;  ///< one per channel
  pipeline::TelemetrySample newest_;
  Instant origin_{};
  bool any_ = false;
  bool dirty_ = true;                                          ///< something else than samples changed the picture
  double drawn_s_ = std::numeric_limits<double>::quiet_NaN();  ///< newest sample in the picture
  bool was_following_ = true;
  QElapsedTimer since_sample_;
  QTimer redraw_timer_;
  QTimer numeral_timer_;
  class QHBoxLayout* bar_ = nullptr;
  QToolButton* follow_button_ = nullptr;
  QLabel* follow_label_ = nullptr;
  TimeField* time_field_ = nullptr;
  QButtonGroup* spans_ = nullptr;
};

}  // namespace fyd::widgets
