// The time interval that the curves show: following the newest sample, or fixed where the operator put it.
//
// Panning, `show` and pausing stop following, zooming does not; `follow` starts it again.
#pragma once

namespace fyd::widgets {

class TimeWindow {
 public:
  static constexpr double kShortest_s = 0.02;
  static constexpr double kLongestLive_s = 240.0;

  explicit TimeWindow(double longest_s = kLongestLive_s) : longest_s_(longest_s) {}

  [[nodiscard]] double from_s() const { return end_s_ - span_s_; }
  [[nodiscard]] double to_s() const { return end_s_; }
  /// No span is longer.
  [[nodiscard]] double longest_s() const { return longest_s_; }
  [[nodiscard]] double span_s() const { return span_s_; }
  [[nodiscard]] bool following() const { return following_; }
  /// The span that `follow` returns to; the operator's choice of window length.
  [[nodiscard]] double chosenSpan_s() const { return chosen_span_s_; }

  /// The newest sample's time; moves the window while following.
  void advance(double newest_s);
  void chooseSpan(double span_s);
  void pause() { following_ = false; }
  void follow();
  /// @param by_s > 0 towards the past
  void pan(double by_s);
  /// @param factor > 1 shows more time; the instant `about_s` stays where it is, while following the newest one
  void zoom(double factor, double about_s);
  void show(double from_s, double to_s);

 private:
  double longest_s_;
  double newest_s_ = 0.0;
  double end_s_ = 0.0;
  double span_s_ = 10.0;
  double chosen_span_s_ = 10.0;
  bool following_ = true;
};

}  // namespace fyd::widgets
