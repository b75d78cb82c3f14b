#include "core/sim/resources.h"

#include <filesystem>

namespace fyd::sim {

namespace fs = std::filesystem;

std::string resourceFolder() {
  std::error_code problem;
  const fs::path program = fs::read_symlink("/proc/self/exe", problem);
  return (program.parent_path().parent_path() / "share/fyd-console").string();
}

std::string findResource(const std::string& given, std::string_view kind) {
  std::error_code problem;
  if (given.empty() || given.find('/') != std::string::npos) return given;
  if (fs::exists(given, problem) && !fs::is_directory(given, problem)) return given;
  const fs::path shipped = fs::path(resourceFolder()) / kind / given;
  for (const char* ending : {"", ".toml"}) {
    std::string path = shipped.string() + ending;
    if (fs::is_regular_file(path, problem)) return path;
  }
  return given;
}

}  // namespace fyd::sim
