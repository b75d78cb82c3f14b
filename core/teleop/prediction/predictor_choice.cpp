#include "core/teleop/prediction/predictor_choice.h"

#include <algorithm>

#include "core/teleop/prediction/expert_predictor.h"
#include "core/teleop/prediction/kalman_predictor.h"
#include "core/teleop/prediction/plain_predictors.h"

namespace fyd::teleop {

std::unique_ptr<Predictor> makePredictor(PredictorChoice choice, PredictorSetup setup) {
  setup.axes = std::clamp<std::size_t>(setup.axes, 1, kMostAxes);
  auto weights = setup.weights ? std::move(setup.weights) : StrokeWeights::builtIn();
  switch (choice) {
    case PredictorChoice::order0: return std::make_unique<PlainPredictor>(0.0, setup.period_s);
    case PredictorChoice::order1: return std::make_unique<PlainPredictor>(1.0, setup.period_s);
    case PredictorChoice::hybrid: return std::make_unique<PlainPredictor>(0.5, setup.period_s);
    case PredictorChoice::kalman: return std::make_unique<KalmanPredictor>();
    case PredictorChoice::ar:
      return std::make_unique<ExpertPredictor>(setup.axes, ExpertPredictor::ExpertSet::ar, std::move(weights));
    case PredictorChoice::experts: break;
  }
  return std::make_unique<ExpertPredictor>(setup.axes, ExpertPredictor::ExpertSet::all, std::move(weights));
}

Result<PredictorChoice> predictorNamed(std::string_view name) {
  const auto found = std::ranges::find(kPredictorNames, name);
  if (found != kPredictorNames.end()) return static_cast<PredictorChoice>(found - kPredictorNames.begin());
  return fail("predictor \"{}\": expected one of {}", name, fmt::join(kPredictorNames, ", "));
}

}  // namespace fyd::teleop
