// Names of the parameters in the operator's language. In English they are made of the identifiers.
#pragma once

#include <QString>

namespace fyd::widgets {

/// @param english "Finger threshold"; one that the table does not know stays as it is
[[nodiscard]] QString parameterName(const QString& english);

}  // namespace fyd::widgets
