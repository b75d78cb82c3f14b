// Text on a cairo drawing. Sizes and places are points, y downward to the baseline.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/report/chart_colours.h"

/// As cairo declares it, so that this header does not include cairo's.
typedef struct _cairo cairo_t;  // NOLINT(modernize-use-using,bugprone-reserved-identifier)

namespace fyd::report {

enum class TextAlign { left, centre, right };

void setColour(cairo_t* cairo, Rgb colour);
/// DejaVu Sans, which covers the letters of most languages.
void setFont(cairo_t* cairo, double size, bool bold = false);
[[nodiscard]] double textWidth(cairo_t* cairo, const std::string& text);
/// `x` is the text's left end, centre or right end, by `align`.
void drawText(cairo_t* cairo, double x, double y, const std::string& text, TextAlign align = TextAlign::left);

/// Lines no wider than `width` in the present font, broken at spaces, or within a word that is longer. Keeps line ends.
[[nodiscard]] std::vector<std::string> wrapText(cairo_t* cairo, std::string_view utf8, double width);

}  // namespace fyd::report
