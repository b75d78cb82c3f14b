// Files that commands write: regular files, which keep mode and owner, or devices and pipes such as /dev/stdout.
#pragma once

#include <fstream>
#include <string>

namespace fyd::cli {

/// Replaces a regular file atomically: a reader sees the old or the new one. @throws Failure when it cannot be written
void writeTextFile(const std::string& path, const std::string& text);

/// For a file that grows while the command runs. @throws Failure when it cannot be opened
[[nodiscard]] std::ofstream openForWriting(const std::string& path);

}  // namespace fyd::cli
