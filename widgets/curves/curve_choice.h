// The operator's choices in a stack of curves, as JSON text for the settings file: which strips are shown, their value
// ranges, whether their times are linked. Strips are named by their ids.
#pragma once

#include <QByteArray>
#include <QString>

#include "widgets/curves/curve_stack.h"

namespace fyd::widgets {

/// Largest magnitude of either end of a chosen range; far beyond every quantity here.
inline constexpr double kLargestChosen = 1e9;

[[nodiscard]] QByteArray choiceOf(const CurveStack& stack);

/// Strips that the text does not name, or names with invalid values, stay as they are.
/// @return what was left out, in words; empty: nothing
[[nodiscard]] QString takeChoice(CurveStack& stack, const QByteArray& choice);

}  // namespace fyd::widgets
