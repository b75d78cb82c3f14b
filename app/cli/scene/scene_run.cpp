// fyd scene run: a path of the haptic point through a scene.
#include <array>
#include <chrono>

#include "app/cli/parts/command.h"
#include "app/cli/parts/output_file.h"
#include "app/cli/parts/probe_path.h"
#include "app/cli/parts/quantiles.h"
#include "app/cli/scene/scene_cli.h"
#include "core/sim/scene_file.h"

namespace fyd::cli {
namespace {

struct RunOptions {
  std::string scene;
  std::string path;
  std::string out;
  bool json = false;
};

struct Row {
  double t_s;
  Vec3 probe_mm;
  scene::SceneTouch touch;
};

constexpr std::array<const char*, 11> kColumns = {"t_s",        "probe_x_mm", "probe_y_mm",        "probe_z_mm",
                                                  "proxy_x_mm", "proxy_y_mm", "proxy_z_mm",        "force_x_N",
                                                  "force_y_N",  "force_z_N",  "stiffness_N_per_mm"};

std::array<double, kColumns.size()> valuesOf(const Row& row) {
  const scene::SceneTouch& at = row.touch;
  return {row.t_s,       row.probe_mm.x, row.probe_mm.y, row.probe_mm.z, at.proxy_mm.x,        at.proxy_mm.y,
          at.proxy_mm.z, at.force_N.x,   at.force_N.y,   at.force_N.z,   at.stiffness_N_per_mm};
}

std::string csvOf(const std::vector<Row>& rows) {
  std::string text = fmt::format("{}\n", fmt::join(kColumns, ","));
  for (const Row& row : rows) text += fmt::format("{}\n", fmt::join(valuesOf(row), ","));
  return text;
}

nlohmann::ordered_json summaryOf(const std::vector<Row>& rows, std::vector<double>& ns) {
  std::size_t touching = 0;
  double largest_N = 0.0, largest_step_N = 0.0, work_mJ = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Vec3& force = rows[i].touch.force_N;
    touching += rows[i].touch.touching ? 1 : 0;
    largest_N = std::max(largest_N, force.norm());
    if (i == 0) continue;
    const Vec3 &before = rows[i - 1].touch.force_N, way = rows[i].probe_mm - rows[i - 1].probe_mm;
    largest_step_N = std::max(largest_step_N, (force - before).norm());
    const Vec3 mean = 0.5 * (force + before);
    work_mJ += mean.x * way.x + mean.y * way.y + mean.z * way.z;
  }
  const Quantiles cost = quantiles(ns);
  return {{"steps", rows.size()},
          {"seconds", rows.back().t_s - rows.front().t_s},
          {"steps_touching", touching},
          {"largest_force_N", largest_N},
          {"largest_step_of_force_N", largest_step_N},
          {"work_on_the_finger_mJ", work_mJ},
          {"step_median_ns", cost.p50},
          {"step_p99_ns", cost.p99},
          {"step_worst_ns", cost.worst}};
}

void run(const RunOptions& options) {
  const scene::LoadedScene file = valueOrFail(sim::openScene(options.scene));
  const ProbePath path = readProbePath(options.path);
  scene::Scene scene = valueOrFail(buildScene(file, modelsOf(valueOrFail(chooseModels(file)))));
  std::vector<Row> rows;
  std::vector<double> ns;
  rows.reserve(path.time_s.size());
  ns.reserve(path.time_s.size());
  for (std::size_t i = 0; i < path.time_s.size(); ++i) {
    const auto start = std::chrono::steady_clock::now();
    const scene::SceneTouch touch = scene.step(path.probe_mm[i], path.time_s[i]);
    ns.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
    rows.push_back({path.time_s[i], path.probe_mm[i], touch});
  }
  if (!options.out.empty()) writeTextFile(options.out, csvOf(rows), {options.scene, options.path});
  nlohmann::ordered_json json = summaryOf(rows, ns);
  if (options.json && options.out.empty()) {
    json["columns"] = kColumns;
    json["rows"] = nlohmann::ordered_json::array();
    for (const Row& row : rows) json["rows"].push_back(valuesOf(row));
  }
  printValues(json, options.json);
}

}  // namespace

void addSceneRun(CLI::App& scene) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = scene.add_subcommand("run", "A path of the haptic point through a scene: its force at each step");
  command->add_option("scene", options->scene, "Scene file, or the name of a scene that comes along")->required();
  command->add_option("--path", options->path, "CSV with t_s, x_mm, y_mm and z_mm")->required();
  command->add_option("-o,--out", options->out, "CSV to write");
  command->add_flag("--json", options->json, "As JSON; with the rows when there is no --out");
  command->callback([options] { run(*options); });
}

}  // namespace fyd::cli
