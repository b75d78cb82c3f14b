// What the core says, in the operator's language. The core speaks English and knows no Qt: its formats and phrases are
// the keys of the translations, which lupdate finds in the core's own sources (core/base/message.h).
#pragma once

#include <QString>
#include <string_view>

#include "core/base/message.h"

namespace fyd::widgets {

/// The message in the language of the window: its translated format with the values filled in, numbers with the
/// language's decimal sign, messages among them translated too. A translation whose places do not fit the values is
/// not used: that message is then English as a whole.
[[nodiscard]] QString coreText(const Message& message);
/// A phrase without values, as a name in one of the core's tables.
[[nodiscard]] QString coreText(std::string_view phrase);

}  // namespace fyd::widgets
