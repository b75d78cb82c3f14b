// What the tuning panels say of a parameter, in words and numbers.
#pragma once

#include <QString>

#include "widgets/tuning_model.h"

namespace fyd::widgets {

/// Its short name: "Measurement lag"; the unit stands beside it.
[[nodiscard]] QString tunedName(const Parameter& parameter);
/// "Stiffness control" for "control.kp"; an unknown room's own name otherwise.
[[nodiscard]] QString roomTitle(std::string_view id);
/// Empty for a pure number.
[[nodiscard]] QString unitText(const Parameter& parameter);
/// The value as its parameter shows it: a number, a choice's word, on or off.
[[nodiscard]] QString valueText(const Parameter& parameter, double value);
/// "was 0.1 · is 0.2 · saved 0.15 · default 0.15 · 0 to 10"
[[nodiscard]] QString tunedFacts(const TuningModel& model, const TunedParameter& parameter);
/// What the station said of it; empty when it uses it.
[[nodiscard]] QString deliveryWords(const TunedParameter& parameter);
/// Whether a search for `text` finds it: in its identifier, name, room or help, each word somewhere.
[[nodiscard]] bool tunedMatches(const Parameter& parameter, const QString& text);

}  // namespace fyd::widgets
