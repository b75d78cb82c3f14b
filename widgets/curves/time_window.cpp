#include "widgets/curves/time_window.h"

#include <algorithm>
#include <cmath>

namespace fyd::widgets {

void TimeWindow::advance(double newest_s) {
  if (!std::isfinite(newest_s)) return;
  newest_s_ = newest_s;
  if (following_) end_s_ = newest_s;
}

void TimeWindow::chooseSpan(double span_s) {
  chosen_span_s_ = std::clamp(span_s, kShortest_s, longest_s_);
  span_s_ = chosen_span_s_;
}

void TimeWindow::follow() {
  following_ = true;
  span_s_ = chosen_span_s_;
  end_s_ = newest_s_;
}

void TimeWindow::pan(double by_s) {
  if (!std::isfinite(by_s)) return;
  following_ = false;
  end_s_ -= by_s;
}

void TimeWindow::zoom(double factor, double about_s) {
  if (!std::isfinite(factor) || factor <= 0.0 || !std::isfinite(about_s)) return;
  const double span_s = std::clamp(span_s_ * factor, kShortest_s, longest_s_);
  if (!following_) end_s_ = about_s + (end_s_ - about_s) * (span_s / span_s_);
  span_s_ = span_s;  // while following, the newest sample stays at the right edge
}

void TimeWindow::show(double from_s, double to_s) {
  if (!std::isfinite(from_s) || !std::isfinite(to_s) || to_s <= from_s) return;
  following_ = false;
  span_s_ = std::clamp(to_s - from_s, kShortest_s, longest_s_);
  end_s_ = to_s;
}

}  // namespace fyd::widgets
