// The safety state in words: what it is, why, what to do.
#pragma once

#include <QColor>
#include <QString>
#include <optional>

#include "core/pipeline/safety.h"

namespace fyd::widgets {

struct StateWords {
  QString word;   ///< "Held"
  QString why;    ///< "The robot is silent."
  QString to_do;  ///< "Check the network, then hold Re-arm."
  QString icon;   ///< shape, so that colour is never alone
};

/// What arming would be refused for at this moment, as the readiness list says it.
struct MissingNow {
  QString why;     ///< "The robot is silent"; empty: nothing is missing
  QString remedy;  ///< "Check the network."
  pipeline::Fault fault = pipeline::Fault::none;
  friend bool operator==(const MissingNow&, const MissingNow&) = default;
};

/// @param fault why the state is Held, or what is missing before Ready
/// @param now none: not known yet
/// @param lateness "this computer was late: ...", said of Held beside the reason and instead of a cable; empty: not late
[[nodiscard]] StateWords describeState(pipeline::SafetyState state, pipeline::Fault fault,
                                       const std::optional<MissingNow>& now = {}, const QString& lateness = {});
[[nodiscard]] QColor stateColour(pipeline::SafetyState state);
/// "Arm" before the first start and "Re-arm" after Held or Stopped.
[[nodiscard]] QString armText(pipeline::SafetyState state);
/// A core phrase as a sentence: first letter large, full stop.
[[nodiscard]] QString asSentence(std::string_view phrase);

}  // namespace fyd::widgets
