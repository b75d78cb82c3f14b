// Files that commands write: regular ones, whose mode and owner stay, or what /dev/stdout and its like stand for.
#pragma once

#include <fstream>
#include <string>

namespace fyd::cli {

/// The whole file at once: a reader sees the old or the new one. @throws Failure when it cannot be written
void writeTextFile(const std::string& path, const std::string& text);

/// For a file that grows while the command runs. @throws Failure when it cannot be opened
[[nodiscard]] std::ofstream openForWriting(const std::string& path);

}  // namespace fyd::cli
