// The perceptron's text file of any content: refused with a reason, or weights that forecast something finite.
#include <cmath>
#include <functional>
#include <string>

#include "core/teleop/prediction/learned_forecast.h"
#include "core/teleop/prediction/predictor_choice.h"
#include "core/teleop/prediction/stroke_weights.h"
#include "tests/fuzz/fuzz.h"

using namespace fyd;
using namespace fyd::teleop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string text(reinterpret_cast<const char*>(data), size);
  // One input of sixteen is laid over the resources' own file, so that some have the right shape. Which ones, all its
  // bytes say: chosen by one byte, most would be, for they cover more, and each takes a hundred times as long. The first
  // byte has no other use; in corpus/stroke_weights/over_* it was chosen so that they are.
  if (size > 3 && std::hash<std::string>()(text) % 16 == 0) {
    const std::string_view usual = strokeWeightsText();
    const std::size_t at = (data[1] * 256U + data[2]) % usual.size();
    const std::string_view over = std::string_view(text).substr(3);
    text = std::string(usual).replace(at, over.size(), over);
  }
  const auto weights = StrokeWeights::parse(text);
  if (!weights) {
    fuzz::require(!weights.error().text().empty());
    return 0;
  }
  const LearnedForecast forecast(*weights);
  MotionHistory history;
  for (int i = 0; i < 12; ++i) history.insert(0.016 * i, {1.0 * i, 0.1 * i * i, 0.0});
  const StrokeForecast look = forecast.forecastFrom(history, history.newest());
  // Weights may be as large as a float: the forecast may then be, too, and the predictor bounds it.
  static_cast<void>(look.displacement(0.05));
  const auto predictor = makePredictor(PredictorChoice::experts, {.axes = 2, .period_s = 0.0, .weights = *weights});
  for (int i = 0; i < 40; ++i) {
    predictor->message(0.016 * i, {1.0 * i, 0.1 * i * i, 0.0});
    for (const double x : predictor->predict(0.016 * i + 0.05)) fuzz::require(std::isfinite(x));
    for (const double v : predictor->velocity(0.016 * i + 0.05)) fuzz::require(std::isfinite(v));
  }
  return 0;
}
