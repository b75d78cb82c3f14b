// Translates the core's messages. The core's messages are English and it does not use Qt: its formats and phrases are
// the keys of the translations, which lupdate finds in the core's own sources (core/base/message.h).
#pragma once

#include <QString>
#include <string_view>

#include "core/base/message.h"

namespace fyd::widgets {

/// The message in the language of the window: its translated format with the values filled in, numbers with the
/// language's decimal sign, messages among them translated too. A translation whose placeholders do not match the
/// values is not used: that message is then shown in English.
[[nodiscard]] QString coreText(const Message& message);
/// Translates a phrase without values, such as a name in one of the core's tables.
[[nodiscard]] QString coreText(std::string_view phrase);

}  // namespace fyd::widgets
