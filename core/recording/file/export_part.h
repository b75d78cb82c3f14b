// The hidden file that an export is written to before it gets its name: ".session.fyd-part-x3Vb9q.csv".
//
// It is locked (flock) while its writer runs. The kernel releases the lock when the process ends, however it ends, so
// an unlocked part file is what a killed program left. No process list is read, so a reused process id cannot mislead.
// On a file system without locks nothing is removed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace fyd::recording {

struct ExportPart {
  std::string path;
  int lock = -1;  ///< the descriptor that holds the lock; the owner closes it
};

/// An empty file beside `wanted`, with the same extension, readable as the user's other files are.
[[nodiscard]] Result<ExportPart> makeExportPart(const std::filesystem::path& wanted);

/// Whether a file's name is one that `makeExportPart` gives.
[[nodiscard]] bool isExportPart(std::string_view name);

/// Removes what killed programs left in a folder: regular files of this user, so named, that no living process has
/// locked. Anything else, and anything in doubt, stays. @return how many
std::size_t removeExportLeftovers(const std::filesystem::path& folder);

}  // namespace fyd::recording
