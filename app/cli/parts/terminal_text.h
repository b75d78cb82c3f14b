// What a terminal is shown of a text that comes from a file, a device or another computer.
#pragma once

#include <string>
#include <string_view>

namespace fyd::cli {

/// Control characters are shown as '?', so that the text cannot steer the terminal; line feed and tabulator stay.
/// @param text UTF-8
[[nodiscard]] std::string forTerminal(std::string_view text);

}  // namespace fyd::cli
