// fyd bench [NAME] [--out DIR] [--cloth NAME] [--runs N] [--seed S] [--data DIR]
#include <functional>
#include <iostream>

#include "app/cli/bench/bench_options.h"
#include "app/cli/bench/cloths.h"
#include "app/cli/bench/table.h"
#include "app/cli/command.h"

namespace fyd::bench {
#define FYD_BENCH(name) Table bench_##name();
#include "benches.inc"
#undef FYD_BENCH
}  // namespace fyd::bench

namespace fyd::cli {
namespace {

struct Subject {
  std::string name;
  std::function<bench::Table()> run;
};

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all = {
#define FYD_BENCH(name) {#name, bench::bench_##name},
#include "benches.inc"
#undef FYD_BENCH
  };
  return all;
}

}  // namespace

void add_bench(CLI::App& app) {
  struct Options {
    std::string name;
    std::string out;
    std::string cloth;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("bench", "Measure speed beside error, against a baseline in the same run");
  std::vector<std::string> names;
  for (const Subject& subject : subjects()) names.push_back(subject.name);
  command->add_option("name", options->name, "Subject; all of them when left out")->check(CLI::IsMember(names));
  command->add_option("--out", options->out,
                      "Folder for one Markdown and one CSV file per subject, and for what it measured");
  command
      ->add_option("--cloth", options->cloth,
                   "The simulated cloth of indentation and controller; membrane, rollers and ideal when left out")
      ->check(CLI::IsMember(std::vector<std::string>(sim::kClothNames.begin(), sim::kClothNames.end())));
  bench::BenchOptions& more = bench::benchOptions();
  command->add_option("--runs", more.runs, "How many runs coupling draws")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  command->add_option("--seed", more.seed, "What coupling and touchpad_coupling draw by")->capture_default_str();
  command->add_option("--data", more.data, "Folder of recordings for predict; tests/data when left out");
  auto* mesh = command->add_option("--mesh", more.mesh, "OBJ, STL or PLY file in mm, for scene");
  auto* path = command->add_option("--path", more.path, "CSV with t_s, x_mm, y_mm and z_mm over that mesh, for scene");
  mesh->needs(path);
  path->needs(mesh);
  command->add_flag("--json", options->json, "As JSON: an array of tables");
  command->callback([options] {
    nlohmann::ordered_json tables = nlohmann::ordered_json::array();
    bench::benchOptions().out = options->out;
    if (!options->cloth.empty()) bench::benchCloths() = {bench::clothOf(options->cloth)};
    for (const Subject& subject : subjects()) {
      if (!options->name.empty() && options->name != subject.name && !subject.name.starts_with(options->name + "_")) {
        continue;  // NAME_… are further tables of the subject NAME
      }
      const bench::Table table = subject.run();
      if (options->json) {
        tables.push_back(bench::toJson(table));
      } else {
        std::cout << bench::toMarkdown(table) << '\n' << std::flush;
      }
      bench::writeBeside(table.subject + ".md", bench::toMarkdown(table));
      bench::writeBeside(table.subject + ".csv", bench::toCsv(table));
    }
    if (options->json) printJson(tables);
  });
}

}  // namespace fyd::cli
