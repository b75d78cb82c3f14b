// Texts of the catalogue: what may go in, how it is compared, and times.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/session/catalogue_types.h"

namespace fyd::session {

/// @return an error that names the first field that is not UTF-8, holds a control character, is too long or, for
/// numbers, not finite; also when the id or the start is not one
[[nodiscard]] Result<void> checkEntry(const CatalogueEntry& entry);
[[nodiscard]] Result<void> checkNotes(std::string_view notes);
[[nodiscard]] Result<void> checkTags(const std::vector<std::string>& tags);

/// Small letters, so that two texts that differ in case only become the same; any language's letters.
[[nodiscard]] std::string foldCase(std::string_view utf8);
/// What `SessionFilter::text` is looked for in.
[[nodiscard]] std::string searchText(const CatalogueEntry& entry);
/// Split at white space.
[[nodiscard]] std::vector<std::string> splitWords(std::string_view text);
/// For `LIKE … ESCAPE '!'`: the text itself, wherever it stands.
[[nodiscard]] std::string likeAnywhere(std::string_view text);

/// Bytes that are no UTF-8 are left out, control characters become spaces (line ends and tabs stay if `lines`): for
/// texts that come from a file and must not keep its recording out of the catalogue.
[[nodiscard]] std::string cleanedText(std::string_view text, bool lines);

/// What a time names: a day, a minute, a second or a millisecond of UTC. Milliseconds since 1970; `end_ms` is past it.
struct UtcSpan {
  std::int64_t begin_ms = 0;
  std::int64_t end_ms = 0;
};
/// "2026-11-21", then optionally "T14:05" (or a space), ":09", ".250", "Z".
[[nodiscard]] Result<UtcSpan> parseUtc(std::string_view text);

}  // namespace fyd::session
