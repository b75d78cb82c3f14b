// Text on a cairo drawing. Sizes and places are points, y downward to the baseline.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/session/chart_colours.h"

/// As cairo declares it, so that who includes this needs no cairo.
typedef struct _cairo cairo_t;  // NOLINT(modernize-use-using,bugprone-reserved-identifier)

namespace fyd::session {

enum class TextAlign { left, centre, right };

void setColour(cairo_t* cairo, Rgb colour);
/// DejaVu Sans, which has the letters of most languages.
void setFont(cairo_t* cairo, double size, bool bold = false);
[[nodiscard]] double textWidth(cairo_t* cairo, const std::string& text);
/// `x` is where the text begins, has its middle, or ends.
void drawText(cairo_t* cairo, double x, double y, const std::string& text, TextAlign align = TextAlign::left);

/// Lines no wider than `width` in the present font, broken at spaces, a longer word where it must be. Keeps line ends.
[[nodiscard]] std::vector<std::string> wrapText(cairo_t* cairo, std::string_view utf8, double width);

}  // namespace fyd::session
