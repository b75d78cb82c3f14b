// The value of a numeral: mean or peak of a signal since the last redraw, steadier than its newest sample.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace fyd::widgets {

/// Gathers samples between two redraws of a numeral.
class RecentValue {
 public:
  enum class Kind {
    mean,  ///< slow quantities: force, indentation, stiffness
    peak   ///< vibrations: the largest magnitude, because their mean is about zero
  };
  explicit RecentValue(Kind kind = Kind::mean) : kind_(kind) {}

  void add(double value) {
    last_ = value;
    any_ = true;
    if (!std::isfinite(value)) return;
    sum_ += value;
    peak_ = std::max(peak_, std::abs(value));
    ++count_;
  }

  /// The mean or peak since the last call; starts anew. NaN when the newest sample is none, or none came.
  double take() {
    const bool there = any_ && std::isfinite(last_);
    const double value = kind_ == Kind::mean ? sum_ / count_ : peak_;
    *this = RecentValue(kind_);
    return there ? value : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  Kind kind_;
  double sum_ = 0.0;
  double peak_ = 0.0;
  double last_ = 0.0;
  int count_ = 0;
  bool any_ = false;
};

}  // namespace fyd::widgets
