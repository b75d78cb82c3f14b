#include "app/cli/parts/terminal_text.h"

namespace fyd::cli {

std::string forTerminal(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
    const bool of_ascii = (byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7F;
    const bool of_latin_1 = byte == 0xC2 && next >= 0x80 && next <= 0x9F;  // U+0080 to U+009F, such as CSI
    out += of_ascii || of_latin_1 ? '?' : text[i];
    if (of_latin_1) ++i;
  }
  return out;
}

}  // namespace fyd::cli
