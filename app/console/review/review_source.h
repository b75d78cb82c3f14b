// The curves of a review: one recording, a second one beside it, and a replay with other parameters, behind one
// CurveSource.
#pragma once

#include <array>
#include <memory>

#include "core/recording/reader/recording.h"
#include "widgets/basics/theme.h"
#include "widgets/curves/curve_buffer.h"
#include "widgets/curves/curve_catalogue.h"

namespace fyd::console {

enum class ReviewLayer : std::uint8_t { session, other, what_if };
inline constexpr std::size_t kReviewLayers = 3;

/// The quantities of figures and replays: the first of widgets::CurveChannel, in that order.
struct ReviewQuantity {
  const char* field;  ///< name in telemetryFields()
  const char* word;
  const char* unit;
  widgets::Quantity quantity;
  int decimals;
};
inline constexpr std::array<ReviewQuantity, 5> kReviewQuantities = {{
    {"force_N", QT_TRANSLATE_NOOP("Review", "Force"), "N", widgets::Quantity::force, 2},
    {"indentation_mm", QT_TRANSLATE_NOOP("Review", "Indentation"), "mm", widgets::Quantity::indentation, 2},
    {"stiffness_N_per_mm", QT_TRANSLATE_NOOP("Review", "Stiffness"), "N/mm", widgets::Quantity::stiffness, 3},
    {"target_N_per_mm", QT_TRANSLATE_NOOP("Review", "Target"), "N/mm", widgets::Quantity::stiffness, 3},
    {"vibration_duty_percent", QT_TRANSLATE_NOOP("Review", "Vibration"), "%", widgets::Quantity::vibration, 0},
}};

/// The next nanosecond, the resolution of a recording's clock: to ask for the row after the one at `time_s`.
[[nodiscard]] inline double justAfter(double time_s) { return time_s + 1e-9; }

/// Index into telemetryFields().
[[nodiscard]] std::size_t fieldIndex(const char* name);

class ReviewSource : public widgets::CurveSource {
 public:
  /// @param quantity a widgets::CurveChannel
  [[nodiscard]] static std::size_t channel(ReviewLayer layer, std::size_t quantity) {
    return static_cast<std::size_t>(layer) * widgets::kCurveChannels + quantity;
  }

  /// nullptr: none. They must outlive this.
  void setSession(const recording::Recording* recording) { layers_[0] = {recording, 0.0}; }
  /// @param later_by_s session time, s, of the other recording's time 0
  void setOther(const recording::Recording* recording, double later_by_s) { layers_[1] = {recording, later_by_s}; }
  void setWhatIf(std::shared_ptr<const widgets::CurveBuffer> replayed) { what_if_ = std::move(replayed); }

  void decimate(std::size_t channel, double from_s, double to_s, std::size_t columns,
                std::vector<widgets::CurveColumn>& out) const override;
  [[nodiscard]] double valueAt(std::size_t channel, double time_s) const override;
  /// Of the session and the other one; a replay has none.
  [[nodiscard]] widgets::CurveRows rows(std::span<const std::size_t> channels, double from_s,
                                        double to_s) const override;
  /// What could not be read since the last call; empty: nothing.
  [[nodiscard]] Message takeProblem() const { return std::exchange(problem_, {}); }

 private:
  struct Layer {
    const recording::Recording* recording = nullptr;
    double later_by_s = 0.0;
  };
  std::array<Layer, 2> layers_;
  std::shared_ptr<const widgets::CurveBuffer> what_if_;
  mutable Message problem_;
};

}  // namespace fyd::console
