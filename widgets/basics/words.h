// Texts of the window outside of a class that has a tr() of its own.
#pragma once

#include <QString>

namespace fyd::widgets {

/// In the window's language. The translation follows from the text alone.
[[nodiscard]] QString tr(const char* text);

}  // namespace fyd::widgets
