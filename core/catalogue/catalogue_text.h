// Texts of the catalogue: validation, comparison, and times.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/catalogue/catalogue_types.h"

namespace fyd::catalogue {

/// @return an error that names the first field that is not UTF-8, holds a control character, is too long or, for
/// numbers, not finite; also for an invalid id or start
[[nodiscard]] Result<void> checkEntry(const CatalogueEntry& entry);
[[nodiscard]] Result<void> checkNotes(std::string_view notes);
[[nodiscard]] Result<void> checkTags(const std::vector<std::string>& tags);
[[nodiscard]] Result<void> checkFilter(const SessionFilter& filter);

/// Lower case, so that texts that differ in case only become the same; for the letters of any language.
[[nodiscard]] std::string foldCase(std::string_view utf8);
/// The text in which `SessionFilter::text` is searched.
[[nodiscard]] std::string searchText(const CatalogueEntry& entry);
/// Split at white space.
[[nodiscard]] std::vector<std::string> splitWords(std::string_view text);
/// Pattern for `LIKE … ESCAPE '!'` that matches the text at any position.
[[nodiscard]] std::string likeAnywhere(std::string_view text);

/// Bytes that are no UTF-8 are left out, control characters become spaces (line ends and tabs stay if `lines`).
[[nodiscard]] std::string cleanedText(std::string_view text, bool lines);
/// For an entry whose texts come from a file and must not keep its recording out of the catalogue: they are cleaned, and
/// what is too long is cut and ends in …; empty tags and those beyond the most are left out.
[[nodiscard]] CatalogueEntry withFittingTexts(CatalogueEntry entry);

/// The span that a time text denotes: a day, a minute, a second or a millisecond of UTC. Milliseconds since 1970;
/// `end_ms` is exclusive.
struct UtcSpan {
  std::int64_t begin_ms = 0;
  std::int64_t end_ms = 0;
};
/// "2026-11-21", then optionally "T14:05" (or a space), ":09", ".250", "Z".
[[nodiscard]] Result<UtcSpan> parseUtc(std::string_view text);

}  // namespace fyd::catalogue
