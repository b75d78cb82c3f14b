// The vertical range of a curve: grows at once with the data, shrinks only when less than half of it is used, and
// always ends on round numbers, so that the scale does not change all the time.
#pragma once

namespace fyd::widgets {

struct Range {
  double lower = 0.0;
  double upper = 1.0;
  friend bool operator==(const Range&, const Range&) = default;
};

class ValueRange {
 public:
  /// @param least shown even when the data need less
  explicit ValueRange(Range least) : least_(least), shown_(least) {}

  /// @param minimum,maximum of the visible data; NaN leaves the range as it is
  /// @return the range to show
  Range fit(double minimum, double maximum);
  [[nodiscard]] Range shown() const { return shown_; }

 private:
  Range least_;
  Range shown_;
};

}  // namespace fyd::widgets
