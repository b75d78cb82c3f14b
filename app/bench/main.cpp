// fyd-bench [NAME | --all] [--quick] [--out DIR] [--cloth NAME] [--runs N] [--seed S] [--data DIR] [--mesh FILE]
// [--path FILE] [--json | --text]: measures speed beside error, against a baseline in the same run; `fyd bench` runs
// it.
#include <chrono>
#include <cstdlib>
#include <functional>
#include <iostream>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/cloths.h"
#include "app/bench/parts/machine.h"
#include "app/bench/parts/numbers_page.h"
#include "app/bench/parts/page_run.h"
#include "app/bench/parts/table.h"
#include "app/cli/parts/cloth_name.h"
#include "app/cli/parts/command.h"
#include "app/cli/parts/program.h"
#include "core/base/end_signals.h"

namespace fyd::bench {
#define FYD_BENCH(name) Table bench_##name();
#include "benches.inc"
#undef FYD_BENCH

namespace {

struct Subject {
  std::string name;
  std::function<Table()> run;
};

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all = {
#define FYD_BENCH(name) {#name, bench_##name},
#include "benches.inc"
#undef FYD_BENCH
  };
  return all;
}

struct Options {
  std::string name;
  std::string out;
  std::string cloth;
  bool all = false;
  bool json = false;
  bool text = false;
};

void addTo(CLI::App& app, Options& options) {
  std::vector<std::string> names;
  names.reserve(subjects().size());
  for (const Subject& subject : subjects()) names.push_back(subject.name);
  auto* name = app.add_option("name", options.name, "Subject; all of them when left out")->check(CLI::IsMember(names));
  auto* out = app.add_option("--out", options.out,
                             "Folder for one Markdown and one CSV file per subject, and for what it measured");
  app.add_flag(
         "--all", options.all,
         "Every subject, and of all of them the page of numbers: numbers.md, numbers.csv and numbers.svg in --out")
      ->needs(out)
      ->excludes(name);
  app.add_flag("--quick", benchOptions().quick,
               "A small part of each subject, within a minute in all: shows that it works, its figures are rough");
  app.add_option("--cloth", options.cloth,
                 "The simulated cloth of indentation and controller; membrane, rollers and ideal when left out")
      ->check(CLI::IsMember(std::vector<std::string>(sim::kClothNames.begin(), sim::kClothNames.end())));
  BenchOptions& more = benchOptions();
  app.add_option("--runs", more.runs, "How many runs coupling draws")
      ->transform(cli::wholeNumberFrom(1, 100'000))
      ->capture_default_str();
  app.add_option("--seed", more.seed, "What coupling, touchpad_coupling, deadband and table2 draw by")
      ->transform(cli::wholeNumberFrom(0))
      ->capture_default_str();
  app.add_option("--data", more.data,
                 "Folder of recordings for predict, reach, deadband and table2; tests/data when left out");
  auto* mesh = app.add_option("--mesh", more.mesh, "OBJ, STL or PLY file in mm, for scene");
  auto* path = app.add_option("--path", more.path, "CSV with t_s, x_mm, y_mm and z_mm over that mesh, for scene");
  mesh->needs(path);
  path->needs(mesh);
  auto* json = app.add_flag("--json", options.json, "As JSON: an array of tables");
  app.add_flag("--text", options.text, "As columns below each other instead of Markdown")->excludes(json);
}

void run(const Options& options) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  std::vector<Table> tables;
  std::vector<Fact> facts = factsOfThisRun();  // before it loads the machine itself
  const auto start = std::chrono::steady_clock::now();
  const auto since_s = [](std::chrono::steady_clock::time_point then) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
  };
  // The page is of drawing in software, wherever it is made.
  if (options.all) ::setenv("QT_QPA_PLATFORM", "offscreen", 1);
  benchOptions().out = options.out;
  makeOut();
  isPageRun() = options.all;
  if (!options.cloth.empty()) benchCloths() = {cli::clothOf(options.cloth)};
  for (const Subject& subject : subjects()) {
    if (!options.name.empty() && options.name != subject.name && !subject.name.starts_with(options.name + "_")) {
      continue;  // NAME_… are further tables of the subject NAME
    }
    const auto begun = std::chrono::steady_clock::now();
    const Table& table = tables.emplace_back(subject.run());
    if (options.all) std::cerr << fmt::format("{}: {:.1f} s\n", subject.name, since_s(begun));
    if (options.json) {
      json.push_back(toJson(table));
      cli::printJson(json);  // each time: what was measured is not lost with a file that cannot be written
    } else {
      std::cout << (options.text ? toText(table) : toMarkdown(table)) << '\n' << std::flush;
    }
    writeBeside(table.subject + ".md", toMarkdown(table));
    writeBeside(table.subject + ".csv", toCsv(table));
  }
  if (options.all) {
    facts.push_back({"measuring took", fmt::format("{:.1f} min", since_s(start) / 60.0)});
    writeNumbersPage(tables, facts);
  }
}

}  // namespace
}  // namespace fyd::bench

// NOLINTNEXTLINE(bugprone-exception-escape): declaring the options throws only for a mistake in their declaration
int main(int argc, char** argv) {
  fyd::makeFailedWritesErrors();
  CLI::App app("Measure speed beside error, against a baseline in the same run", "fyd bench");
  fyd::bench::Options options;
  fyd::bench::addTo(app, options);
  app.callback([&options] { fyd::bench::run(options); });
  return fyd::cli::runProgram(app, argc, argv);
}
