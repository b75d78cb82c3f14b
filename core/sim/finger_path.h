// Where the simulated finger is at each moment: a demonstration, a constant press or a recorded hand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace fyd::sim {

/// Touchpad frame: x right, y back, origin at the camera's axis.
struct FingerState {
  double x_mm = 0.0;
  double y_mm = 0.0;
  double indentation_mm = 0.0;  ///< ≥ 0, pressed down is positive
  bool lifted = true;           ///< true: the finger does not touch the cloth, indentation is 0
};

inline constexpr double kUsableHalfWidth_mm = 45.0;
inline constexpr double kUsableHalfDepth_mm = 30.0;
inline constexpr double kDeepestPress_mm = 8.0;

class FingerPath {
 public:
  /// Presses and strokes over the cloth with lifting in between; always the same; repeats after about 16 s.
  [[nodiscard]] static FingerPath demonstration();

  /// A finger that stays where it is. Values are clamped to the usable area; a depth ≤ 0 or NaN is a lifted finger.
  [[nodiscard]] static FingerPath constant(double x_mm, double y_mm, double indentation_mm);

  /// A recording with columns t_s, x_mm, y_mm, z_mm (z up). One whose x and y lie within ±45 × ±30 mm and whose z lies
  /// within −8 … 20 mm is taken as it stands, indentation = −z. Any other is centred and scaled into that area, x and
  /// y by the same factor; its z is mapped so that the lowest value is 8 mm deep and the highest 30 % of the samples
  /// do not touch. A row whose x, y and z are all NaN is a lifted finger, to and from which no line is drawn. After the
  /// end the finger stays lifted for 0.5 s and the recording starts again.
  /// @return an error with file and line for any other NaN, values beyond 10⁶ mm, time that does not increase, and
  ///         all that readCsv refuses
  [[nodiscard]] static Result<FingerPath> fromCsv(const std::string& path);
  /// The same of such a file's text. @param source_name the file's, for messages
  [[nodiscard]] static Result<FingerPath> fromCsvText(std::string_view text, const std::string& source_name);

  struct Knot {
    double time_s = 0.0;
    FingerState state;
    double above_mm = 0.0;  ///< of a lifted finger: its height above the cloth; NaN: not known
  };
  /// Linear between knots, so a finger that is lifted or put down meets the cloth where the line does. After the last
  /// one as fromCsv.
  /// @param knots times rising from 0; one and more
  [[nodiscard]] static FingerPath fromKnots(std::vector<Knot> knots);

  /// The same, `speed` times as fast; once or again and again.
  /// @param speed above 0
  [[nodiscard]] FingerPath played(double speed, bool loop) const;

  /// The finger at a time since the start, in s; linear between two rows; O(log n), without allocation. Beside a row
  /// whose height is not known: as in the earlier of the two rows. Before 0 and for NaN: the first row.
  [[nodiscard]] FingerState at(double time_s) const;

  /// Time after which the path repeats, s; 0 for a constant one.
  [[nodiscard]] double duration_s() const { return duration_s_; }
  [[nodiscard]] std::size_t rows() const { return knots_.size(); }

 private:
  std::vector<Knot> knots_;
  double duration_s_ = 0.0;
  bool loops_ = true;  // false: lifted after the end
};

}  // namespace fyd::sim
