// What the core says to an operator, in English, with %1, %2, … where it puts a value in. Nothing else belongs here:
// the translations stand in resources/translations.
#pragma once

#include <span>

namespace fyd::widgets {

[[nodiscard]] std::span<const char* const> coreSentenceTable();

}  // namespace fyd::widgets
