#include "app/bench/parts/bench_options.h"

#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "app/cli/parts/command.h"
#include "app/cli/parts/output_file.h"
#include "core/base/system_reason.h"

namespace fyd::bench {

void makeOut() {
  const std::string& folder = benchOptions().out;
  if (folder.empty()) return;
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) throw cli::Failure(about(folder, systemReason(problem)));
  if (::access(folder.c_str(), W_OK | X_OK) != 0) throw cli::Failure(about(folder, systemReason(errno)));
}

void writeBeside(const std::string& name, const std::string& text) {
  const std::string& folder = benchOptions().out;
  if (folder.empty()) return;
  cli::writeTextFile(std::filesystem::path(folder) / name, text);
}

}  // namespace fyd::bench
