// Texts of the tuning panels about a parameter.
#pragma once

#include <QString>

#include "widgets/tuning/tuning_model.h"

namespace fyd::widgets {

/// Its short name without unit: "Measurement lag".
[[nodiscard]] QString tunedName(const Parameter& parameter);
/// "Stiffness control" for "control.kp"; an unknown module's own name otherwise.
[[nodiscard]] QString moduleTitle(std::string_view id);
/// Empty for a pure number.
[[nodiscard]] QString unitText(const Parameter& parameter);
/// The value as its parameter shows it: a number, a choice's word, on or off.
[[nodiscard]] QString valueText(const Parameter& parameter, double value);
/// "was 0.1 · is 0.2 · saved 0.15 · default 0.15 · 0 to 10"
[[nodiscard]] QString tunedFacts(const TuningModel& model, const TunedParameter& parameter);
/// The station's answer to it; empty when it is confirmed.
[[nodiscard]] QString deliveryWords(const TunedParameter& parameter);
/// Whether a search for `text` finds it: in its identifier, name, module or help, each word somewhere.
[[nodiscard]] bool tunedMatches(const Parameter& parameter, const QString& text);

}  // namespace fyd::widgets
