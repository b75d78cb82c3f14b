// Checks what a name that is to be written refers to: only regular files are written, never a device, a pipe, a socket
// or a folder, which a renamed file would silently replace.
#pragma once

#include <string>

#include <sys/types.h>

#include "core/base/error.h"

namespace fyd {

/// The file that is really written. A name that is a link stays one: the file it leads to is replaced.
struct WriteTarget {
  std::string path;     ///< links followed to their end
  bool exists = false;  ///< then it has:
  mode_t mode = 0;
  uid_t owner = 0;
  gid_t group = 0;
};

/// @return an error: what is there is not a regular file, the links run in a circle, or this user may not write the
/// file
[[nodiscard]] Result<WriteTarget> writeTargetOf(const std::string& path);

/// Gives a new file, opened as `descriptor`, mode and owner of the one it is going to replace; a new name needs
/// nothing.
/// @return an error when the owner cannot be kept, which only root may do for others
[[nodiscard]] Result<void> takeOver(const WriteTarget& replaced, int descriptor);

/// Whether the name is one of this process's own descriptors, as /dev/stdout and /dev/fd/3 are: whatever it is, the
/// caller's shell opened it to be written.
[[nodiscard]] bool isOwnDescriptor(const std::string& path);

}  // namespace fyd
