// fyd bench …: runs fyd-bench, from the same folder as this program, with the same arguments.
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <vector>

#include "app/cli/parts/command.h"
#include "core/base/system_reason.h"

namespace fyd::cli {

void add_bench(CLI::App& app) {
  CLI::App* command = app.add_subcommand("bench", "Measure speed beside error, against a baseline in the same run");
  command->set_help_flag();  // fyd-bench's own
  command->prefix_command();
  command->callback([command] {
    std::error_code problem;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", problem).parent_path() / "fyd-bench";
    std::vector<std::string> words = command->remaining();
    words.insert(words.begin(), program.string());
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(program.c_str(), arguments.data());
    if (errno == ENOENT) throw Failure(say("{}: not found; it is built with FYD_BUILD_BENCHMARKS", program.string()));
    throw Failure(about(program.string(), systemReason(errno)));
  });
}

}  // namespace fyd::cli
