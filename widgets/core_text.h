// Sentences of the core in the operator's language. The core speaks English and knows no Qt; the table of what it says
// stands in core_text.cpp, with %1, %2, … where the core puts a value in.
#pragma once

#include <QString>
#include <string_view>

namespace fyd::widgets {

/// @param english a word, phrase or whole sentence as the core made it; values in it are found and kept
/// @return the translation; the English itself when there is none
[[nodiscard]] QString coreText(std::string_view english);
[[nodiscard]] QString coreText(const QString& english);

}  // namespace fyd::widgets
