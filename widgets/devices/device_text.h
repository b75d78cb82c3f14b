// Texts about devices for the operator.
#pragma once

#include <QString>
#include <string>

#include "core/base/message.h"

namespace fyd::widgets {

/// "IR sensor 1": a device's own words with a capital; translated.
[[nodiscard]] QString deviceWord(const Message& words);
/// A value with its unit, in as many decimals as an operator can use; "—" when it is not known.
[[nodiscard]] QString deviceValue(double number, const std::string& unit);
/// A long path may break after each of its parts.
[[nodiscard]] QString breakable(QString path);
/// What was typed or pasted, without spaces around it, and without the invisible breaks of a `breakable` text that was
/// copied.
[[nodiscard]] QString asEntered(QString text);

}  // namespace fyd::widgets
