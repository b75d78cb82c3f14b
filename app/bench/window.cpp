// The operator's window: frames, pan and zoom, the stop key, start, soak. fyd has no Qt, so that it runs everywhere;
// fyd-window-bench beside it does the measuring and gives its table as JSON.
#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "app/bench/parts/page_run.h"
#include "app/bench/parts/table.h"

namespace fyd::bench {

Table bench_window() {
  Table table{.subject = "window", .title = "The operator's window", .columns = {{"measured", Role::method}}};
  static const std::map<std::string, Role> roles = {{"compared", Role::group}, {"measured", Role::method},
                                                    {"scale", Role::group},    {"p50", Role::cost},
                                                    {"unit", Role::unit},      {"error", Role::error}};
  std::error_code problem;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", problem).parent_path() / "fyd-window-bench";
  if (!std::filesystem::exists(program, problem)) {
    table.notes.push_back("Not measured: fyd-window-bench is not there, this build has no window.");
    return table;
  }
  std::FILE* pipe = popen(("'" + program.string() + "'" +
                           wholePageOrQuick("", " --seconds 5 --hours 0.05", " --only frame,naive --seconds 0.3"))
                              .c_str(),
                          "r");
  std::string text;
  std::array<char, 4096> block{};
  if (pipe != nullptr) {
    while (const std::size_t got = std::fread(block.data(), 1, block.size(), pipe)) text.append(block.data(), got);
  }
  const bool good = pipe != nullptr && pclose(pipe) == 0;
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_object()) {
    table.columns.clear();
    for (const auto& name : json["columns"]) {
      const std::string heading = name.get<std::string>();
      const auto known = roles.find(heading);
      table.columns.emplace_back(heading, "", known == roles.end() ? Role::figure : known->second);
    }
    table.rows = json.value("rows", table.rows);
    table.notes = json.value("notes", table.notes);
  }
  if (!good) table.notes.push_back("fyd-window-bench failed: rows are missing.");
  return table;
}

}  // namespace fyd::bench
