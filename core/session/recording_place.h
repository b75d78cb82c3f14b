// Where a recording lies: names, the kind of file system, the lock that says "a recorder lives", syncing of folders.
#pragma once

#include <string>

#include "core/base/error.h"

namespace fyd::session {

[[nodiscard]] std::string partialOf(const std::string& path);

/// @return an error when a recording cannot begin there: no folder, not writable, a network share, a name taken
[[nodiscard]] Result<void> checkPlace(const std::string& path);
/// Makes what happened to names in the file's folder last.
[[nodiscard]] Result<void> syncFolder(const std::string& path);
/// Gives the file its new name; never replaces another file.
[[nodiscard]] Result<void> renameNew(const std::string& from, const std::string& to);

/// @param file_descriptor opened for writing; the lock goes with its last close, however the process ends
[[nodiscard]] bool lockAsRecorder(int file_descriptor);
[[nodiscard]] bool recorderLives(int file_descriptor);

}  // namespace fyd::session
