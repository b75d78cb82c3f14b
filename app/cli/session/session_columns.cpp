// fyd session columns: what each column of a recording means.
#include <iostream>

#include "app/cli/session/session_cli.h"
#include "core/recording/format/recording_format.h"

namespace fyd::cli {
namespace {

using recording::Column;
using recording::TableLayout;

std::string typeOf(const Column& column) {
  constexpr std::array<std::string_view, recording::kBytesOfType.size()> kWords{"u8",  "u16", "u32", "u64",
                                                                                "i16", "i32", "i64", "f64"};
  const std::string_view word = kWords[static_cast<std::size_t>(column.type)];
  return column.count == 1 ? std::string(word) : fmt::format("{}[{}]", word, column.count);
}

/// Every table with its own columns; the min/max tables have those of /telemetry.
std::vector<const TableLayout*> tables() {
  std::vector<const TableLayout*> out;
  for (std::size_t i = 0; i < recording::kTableCount; ++i) {
    const TableLayout& layout = recording::layoutOf(static_cast<recording::Table>(i));
    if (!layout.columns.empty() && !std::string_view(layout.path).starts_with("/overview")) out.push_back(&layout);
  }
  out.push_back(&recording::commitLayout());
  return out;
}

void printMarkdown() {
  for (const TableLayout* table : tables()) {
    std::cout << fmt::format("## {}\n\nA row is {}.\n\n| column | type | unit | meaning |\n|---|---|---|---|\n",
                             table->path, table->help);
    for (const Column& column : table->columns)
      std::cout << fmt::format("| `{}` | {} | {} | {} |\n", column.name, typeOf(column), column.unit, column.help);
    std::cout << '\n';
  }
}

nlohmann::ordered_json asJson() {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const TableLayout* table : tables()) {
    nlohmann::ordered_json columns = nlohmann::ordered_json::array();
    for (const Column& column : table->columns)
      columns.push_back(
          {{"name", column.name}, {"type", typeOf(column)}, {"unit", column.unit}, {"meaning", column.help}});
    out.push_back({{"table", table->path}, {"row", table->help}, {"columns", columns}});
  }
  return out;
}

}  // namespace

void addSessionColumns(CLI::App& parent) {
  auto json = std::make_shared<bool>(false);
  CLI::App* command = parent.add_subcommand("columns", "What each column of a recording means, as the manual's tables");
  command->add_flag("--json", *json, "As JSON");
  command->callback([json] {
    if (*json)
      printJson(asJson());
    else
      printMarkdown();
  });
}

}  // namespace fyd::cli
