// The predictors by name, and the function that makes one.
// Stability: stable since 0.1
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "core/base/api.h"
#include "core/base/error.h"
#include "core/teleop/prediction/predictor.h"

namespace fyd::teleop {

enum class PredictorChoice : std::uint8_t { order0, order1, hybrid, kalman, ar, experts };
/// "default" stands for the experts.
inline constexpr std::array<std::string_view, 6> kPredictorNames = {"order0", "order1", "hybrid",
                                                                    "kalman", "ar",     "default"};
static_assert(kPredictorNames.size() == static_cast<std::size_t>(PredictorChoice::experts) + 1, "a name for each");

class StrokeWeights;

struct PredictorSetup {
  std::size_t axes = 1;                                    ///< 1 … kMostAxes; what is beyond counts as the nearest
  double period_s = 0.0;                                   ///< of the sender's messages; 0: not known
  std::shared_ptr<const StrokeWeights> weights = nullptr;  ///< of the perceptron; null: StrokeWeights::builtIn()
};
/// Never null. A number that is no choice stands for the experts.
[[nodiscard]] FYD_API std::unique_ptr<Predictor> makePredictor(PredictorChoice choice, PredictorSetup setup);
/// By its name on the command line. @return an error with the names when there is none of that name
[[nodiscard]] FYD_API Result<PredictorChoice> predictorNamed(std::string_view name);

}  // namespace fyd::teleop
