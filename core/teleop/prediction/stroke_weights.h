// The text of resources/predictors/strokes.perceptron, embedded in the library.
#pragma once

#include <string_view>

namespace fyd::teleop {

[[nodiscard]] std::string_view strokeWeightsText();

}  // namespace fyd::teleop
