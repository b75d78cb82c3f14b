// A forecast trained on other people's strokes: a perceptron with two hidden layers of 64 units.
//
// Its inputs are the last ten steps of the motion, 1/60 s each, in the motion's own frame (first axis: along the last
// three steps; second: to where the steps before came from) and divided by their RMS, with the logarithm of that RMS
// and the age of the motion. Its outputs are the displacements after 1/60 … 12/60 s in the same frame and scale. So the
// forecast does not depend on a stroke's direction; out of the plane of the motion (three axes) the position is held.
//
//   out = scale · (W3·relu(W2·relu(W1·in + b1) + b2) + L·in + b3)
//
// Weights: resources/predictors/strokes.perceptron, made by train_strokes.py beside it.
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/teleop/prediction/motion_history.h"

namespace fyd::teleop {

class StrokeWeights {
 public:
  static constexpr std::size_t kLags = 10, kKnots = 12, kHidden = 64;
  static constexpr std::size_t kInputs = 2 * kLags + 2, kOutputs = 2 * kKnots;
  /// Of the trained ones the largest is 3. From weights of 10¹² forecasts came whose squares are beyond a float, so that
  /// what learns from them had no number left.
  static constexpr double kLargestWeight = 1000.0;

  /// @param text as train_strokes.py writes it
  /// @return an error when it has another shape, an entry that is no number, or a weight beyond ±kLargestWeight
  [[nodiscard]] static Result<std::shared_ptr<const StrokeWeights>> parse(std::string_view text);
  /// Those embedded in the library.
  [[nodiscard]] static std::shared_ptr<const StrokeWeights> builtIn();

  using Inputs = std::array<float, kInputs>;
  using Outputs = std::array<float, kOutputs>;
  using Hidden = std::array<float, kHidden>;
  /// @param second set to the activations of the second hidden layer
  [[nodiscard]] Outputs operator()(const Inputs& inputs, Hidden& second) const;

 private:
  std::vector<float> numbers_;
};

/// The perceptron's forecast from one message on.
class StrokeForecast {
 public:
  /// @param horizon_s 0 and more; beyond the last knot extrapolated at half the slope
  /// @return mm
  [[nodiscard]] Position displacement(double horizon_s) const;
  /// From mm to the motion's frame and scale. The part out of its plane is lost.
  [[nodiscard]] std::array<float, 2> toMotionFrame(const Position& mm) const;
  /// The inverse; mm.
  [[nodiscard]] Position fromMotionFrame(const std::array<float, 2>& in_plane) const;
  [[nodiscard]] const StrokeWeights::Hidden& hidden() const { return hidden_; }

 private:
  friend class LearnedForecast;

  double scale_mm_ = 1.0;
  Position ahead_{}, across_{};  ///< unit vectors of the motion's frame; both zero: no forecast
  StrokeWeights::Hidden hidden_{};
  /// Displacement after k · LearnedForecast::kStep_s, mm; the first is 0.
  std::array<Position, StrokeWeights::kKnots + 1> knots_{};
};

class LearnedForecast {
 public:
  static constexpr double kStep_s = 1.0 / 60.0;

  explicit LearnedForecast(std::shared_ptr<const StrokeWeights> weights) : weights_(std::move(weights)) {}

  /// Forecast of a motion from its newest message `from` on. Never fails: a motion of one message stays where it is.
  [[nodiscard]] StrokeForecast forecastFrom(const MotionHistory& history, const DatedPosition& from) const;

 private:
  std::shared_ptr<const StrokeWeights> weights_;
};

}  // namespace fyd::teleop
