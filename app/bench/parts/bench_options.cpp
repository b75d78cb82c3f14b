#include "app/bench/parts/bench_options.h"

#include <filesystem>

#include "app/cli/parts/command.h"
#include "app/cli/parts/output_file.h"
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
