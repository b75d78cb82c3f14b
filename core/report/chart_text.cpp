#include "core/report/chart_text.h"

#include <cairo.h>

namespace fyd::report {
namespace {

/// Bytes of the UTF-8 character that begins with `first`.
std::size_t lengthOf(char first) {
  const auto byte = static_cast<unsigned char>(first);
  return byte < 0x80 ? 1 : (byte < 0xE0 ? 2 : (byte < 0xF0 ? 3 : 4));
}

/// Adds one word to the lines; the last line is the one being filled.
void addWord(cairo_t* cairo, std::vector<std::string>& lines, const std::string& word, double width) {
  std::string& line = lines.back();
  const std::string joined = line.empty() ? word : line + " " + word;
  if (textWidth(cairo, joined) <= width) {
    line = joined;
    return;
  }
  if (!line.empty()) lines.emplace_back();
  if (textWidth(cairo, word) <= width) {
    lines.back() = word;
    return;
  }
  for (std::size_t at = 0; at < word.size();) {
    const std::string character = word.substr(at, lengthOf(word[at]));
    if (!lines.back().empty() && textWidth(cairo, lines.back() + character) > width) lines.emplace_back();
    lines.back() += character;
    at += character.size();
  }
}

}  // namespace

void setColour(cairo_t* cairo, Rgb colour) {
  cairo_set_source_rgb(cairo, (colour >> 16 & 0xFF) / 255.0, (colour >> 8 & 0xFF) / 255.0, (colour & 0xFF) / 255.0);
}

void setFont(cairo_t* cairo, double size, bool bold) {
  cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, size);
}

double textWidth(cairo_t* cairo, const std::string& text) {
  cairo_text_extents_t extents{};
  cairo_text_extents(cairo, text.c_str(), &extents);
  return extents.x_advance;
}

void drawText(cairo_t* cairo, double x, double y, const std::string& text, TextAlign align) {
  if (align == TextAlign::centre) x -= textWidth(cairo, text) / 2.0;
  if (align == TextAlign::right) x -= textWidth(cairo, text);
  cairo_move_to(cairo, x, y);
  cairo_show_text(cairo, text.c_str());
}

std::vector<std::string> wrapText(cairo_t* cairo, std::string_view utf8, double width) {
  std::vector<std::string> lines(1);
  std::string word;
  const auto endWord = [&] {
    if (!word.empty()) addWord(cairo, lines, word, width);
    word.clear();
  };
  for (const char c : utf8) {
    if (c == '\n' || c == ' ' || c == '\t') {
      endWord();
      if (c == '\n') lines.emplace_back();
    } else {
      word += c;
    }
  }
  endWord();
  return lines;
}

}  // namespace fyd::report
