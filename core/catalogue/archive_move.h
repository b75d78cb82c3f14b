// Moves a closed recording to shared storage; at every moment a complete copy exists.
//
//   copy to a hidden name there → fsync → read back, compare size and hash → rename → catalogue → remove the source
//
// If any step fails, the source stays as it was. A complete copy that exists already is accepted, so that an
// interrupted move is finished by repeating it.
#pragma once

#include <functional>
#include <string>

#include "core/base/error.h"

namespace fyd::catalogue {

struct StoredFile {
  std::string path;  ///< absolute, where it is now
  std::uint64_t bytes = 0;
  bool was_there = false;  ///< an earlier, interrupted move had copied it already
};

/// @param stored called with the new path when the copy is safe, before the source is removed; its error keeps both
/// @return an error that says what happened and where the complete file is: no such file or folder, not enough space,
/// another file of that name, a copy that differs from the source, a source that changed meanwhile
[[nodiscard]] Result<StoredFile> moveFile(const std::string& file, const std::string& folder,
                                          const std::function<Result<void>(const std::string&)>& stored);

/// moveFile for a recording: refuses an incomplete one, and updates its path in the catalogue.
[[nodiscard]] Result<StoredFile> storeClosed(const std::string& file, const std::string& folder,
                                             const std::string& catalogue_word);

}  // namespace fyd::catalogue
