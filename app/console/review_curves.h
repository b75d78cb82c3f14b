// The curves of a review: strips on one time axis, the cursor and the marks A and B across all of them, and beside
// each strip its values at the cursor.
#pragma once

#include <QTimer>
#include <QWidget>
#include <limits>
#include <vector>

#include "app/console/review_source.h"
#include "widgets/curve_strip.h"
#include "widgets/readout.h"
#include "widgets/time_window.h"

namespace fyd::console {

class ReviewCurves : public QWidget {
  Q_OBJECT
 public:
  explicit ReviewCurves(QWidget* parent = nullptr);

  [[nodiscard]] ReviewSource& source() { return source_; }
  [[nodiscard]] const widgets::TimeWindow& window() const { return window_; }
  [[nodiscard]] widgets::CurveStrip* strip(std::size_t index) const { return strips_[index]; }
  [[nodiscard]] std::size_t stripCount() const { return strips_.size(); }
  [[nodiscard]] widgets::Readout* readout(std::size_t index) const { return readouts_[index]; }

  /// The session's length changed or another one is shown.
  void setDuration(double duration_s) { duration_s_ = duration_s; }
  void show(double from_s, double to_s);
  void setCursor_s(double time_s);
  [[nodiscard]] double cursor_s() const { return cursor_s_; }
  void setMark(int which, double time_s);  ///< 0: A, 1: B; NaN takes it away
  [[nodiscard]] double mark_s(int which) const { return marks_s_[which]; }
  /// The sources changed: draws soon.
  void redrawSoon();
  /// Draws now; for tests and screenshots.
  void redraw();

 signals:
  void windowShown(double from_s, double to_s);
  void cursorAsked(double time_s);
  void problem(const QString& text);

 private:
  void addStrip(const QString& title, const QString& unit, widgets::Range least, std::vector<std::size_t> quantities,
                bool last);
  void moveInto();

  ReviewSource source_;
  widgets::TimeWindow window_{std::numeric_limits<double>::max()};
  std::vector<widgets::CurveStrip*> strips_;
  std::vector<widgets::Readout*> readouts_;
  std::vector<std::vector<std::size_t>> quantities_;  // of each strip
  double duration_s_ = 0.0;
  double cursor_s_ = 0.0;
  double marks_s_[2] = {pipeline::kNone, pipeline::kNone};
  QTimer timer_;
};

}  // namespace fyd::console
