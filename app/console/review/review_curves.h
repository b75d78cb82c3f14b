// The curves of a review: the stack of strips on a recording, held within its length, and beside each strip its values
// at the cursor.
#pragma once

#include <QTimer>
#include <QWidget>

#include "app/console/review/review_source.h"
#include "widgets/curves/curve_stack.h"

namespace fyd::console {

class ReviewCurves : public QWidget {
  Q_OBJECT
 public:
  explicit ReviewCurves(QWidget* parent = nullptr);

  [[nodiscard]] ReviewSource& source() { return source_; }
  [[nodiscard]] widgets::CurveStack* stack() const { return stack_; }
  [[nodiscard]] const widgets::TimeWindow& window() const { return stack_->window(); }
  [[nodiscard]] widgets::CurveStrip* strip(std::size_t index) const { return stack_->strip(index); }
  [[nodiscard]] widgets::Readout* readout(std::size_t index) const { return stack_->readout(index); }

  /// The session's length changed or another one is shown.
  void setDuration(double duration_s) { duration_s_ = duration_s; }
  void show(double from_s, double to_s);
  void setCursor_s(double time_s);
  [[nodiscard]] double cursor_s() const { return stack_->cursor_s(); }
  /// The sources changed: draws soon.
  void redrawSoon();
  /// Draws now; for tests and screenshots.
  void redraw();

 signals:
  void windowShown(double from_s, double to_s);
  void cursorAsked(double time_s);
  void drawn();
  void problem(const QString& text);

 private:
  void addStrips();

  ReviewSource source_;
  widgets::CurveStack* stack_ = nullptr;
  double duration_s_ = 0.0;
  QTimer timer_;
};

}  // namespace fyd::console
