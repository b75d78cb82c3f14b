#include "app/cli/bench/bench_options.h"

#include <filesystem>

#include "app/cli/command.h"
#include "app/cli/output_file.h"
#include "core/base/system_reason.h"

namespace fyd::bench {

void writeBeside(const std::string& name, const std::string& text) {
  const std::string& folder = benchOptions().out;
  if (folder.empty()) return;
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) throw cli::Failure(about(folder, systemReason(problem)));
  cli::writeTextFile(std::filesystem::path(folder) / name, text);
}

}  // namespace fyd::bench
