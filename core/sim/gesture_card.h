// A gesture as a small text file: a finger's motion on the cloth, for the simulated finger to repeat through the whole
// chain as in a live session.
//
//   format = "FYD gesture 1"          TOML, each key once, no others
//   name = "a circle on foam"         1 … 200 bytes
//   source = "foam.fyd, touch 3"      may be missing, as may the two below
//   speed = 1.0                       factor on the speed of playing, 0.05 … 20
//   loop = true                       false: once, then the finger stays lifted
//   ---
//   t_s,x_mm,y_mm,depth_mm            CSV: time rising from 0, at most 600 s; ±45, ±30, 0 … 8 mm; depth 0: lifted
//   0,1.5,-2,0.8
//
// Nothing is fitted or scaled: positions are played as they stand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/sim/finger_path.h"

namespace fyd::sim {

inline constexpr double kSlowestGesture = 0.05, kFastestGesture = 20.0;  ///< factors on the speed of playing

struct GestureCard {
  std::string name;
  std::string source;
  double speed = 1.0;
  bool loop = true;
  std::vector<FingerPath::Knot> rows;  ///< at least two

  [[nodiscard]] double duration_s() const { return rows.empty() ? 0.0 : rows.back().time_s; }
  [[nodiscard]] FingerPath path() const;
};

/// Whether a card may be called so.
[[nodiscard]] bool isGestureName(std::string_view name);
/// Whether the text begins as a card that is written here, or has the line --- of any card.
[[nodiscard]] bool isGestureCard(std::string_view text);
/// @return an error with file and line, the value and what was expected
[[nodiscard]] Result<GestureCard> parseGesture(std::string_view text, std::string_view source_name);
/// The text that parseGesture reads. @return an error for a card that it would refuse
[[nodiscard]] Result<std::string> formatGesture(const GestureCard& card);
/// The part from `from_s` to `to_s`, beginning at 0. @return an error when less than two rows lie in it
[[nodiscard]] Result<GestureCard> trimmed(const GestureCard& card, double from_s, double to_s);

inline constexpr std::size_t kLargestCard_bytes = std::size_t{32} << 20;
/// @return an error as parseGesture gives it, for a file that cannot be read, and for a larger one
[[nodiscard]] Result<GestureCard> readGestureFile(const std::string& path);
/// The simulated finger's path from a file or a pipe, which is opened once: a card, or a recording as
/// FingerPath::fromCsv takes it.
[[nodiscard]] Result<FingerPath> readFingerFile(const std::string& path);

}  // namespace fyd::sim
