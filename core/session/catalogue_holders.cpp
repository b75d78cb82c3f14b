// Who has a file open, from /proc: so that "locked" comes with a name.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/session/catalogue_database.h"

namespace fyd::session {

std::string holdersOf(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path wanted = fs::weakly_canonical(path, error);
  std::string out;
  for (const fs::directory_entry& process : fs::directory_iterator("/proc", error)) {
    const std::string number = process.path().filename();
    if (!std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; })) continue;
    std::error_code unseen;  // another user's, or just ended
    bool holds = false;
    fs::directory_iterator descriptor(process.path() / "fd", unseen);
    for (; !unseen && descriptor != fs::directory_iterator(); descriptor.increment(unseen)) {
      std::error_code closed;
      if (fs::read_symlink(descriptor->path(), closed) == wanted) holds = true;
    }
    if (!holds) continue;
    std::string command;
    std::getline(std::ifstream(process.path() / "comm") >> std::ws, command);
    out += fmt::format("{}{} (process {})", out.empty() ? "" : ", ", command, number);
  }
  return out;
}

}  // namespace fyd::session
