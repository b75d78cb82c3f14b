// What an operator chose of a stack of curves, as a text that a file of settings keeps: which are shown, between which
// values, whether their times go together. JSON, with the strips by their ids.
#pragma once

#include <QByteArray>
#include <QString>

#include "widgets/curve_stack.h"

namespace fyd::widgets {

/// Of both ends of a chosen range; far beyond every quantity here.
inline constexpr double kLargestChosen = 1e9;

[[nodiscard]] QByteArray choiceOf(const CurveStack& stack);

/// Strips that the text does not name, or of which it says nonsense, stay as they are.
/// @return what was left out, in words; empty: nothing
[[nodiscard]] QString takeChoice(CurveStack& stack, const QByteArray& choice);

}  // namespace fyd::widgets
