// fyd scene explain and keys: what a scene file contains and costs, and the keys that it may have.
#include <chrono>

#include "app/cli/parts/command.h"
#include "app/cli/parts/quantiles.h"
#include "app/cli/scene/scene_cli.h"
#include "core/scene/mesh/vector.h"
#include "core/scene/scene_digest.h"
#include "core/sim/scene_file.h"

namespace fyd::cli {
namespace {

struct ExplainOptions {
  std::string scene;
  bool json = false;
};

/// The cost of a step near each body, measured on this machine: the haptic point visits every n-th triangle, half a
/// mean edge deep.
/// @param time_s of the scene, which goes on from body to body: a step that is no later than the last one does nothing
Quantiles costOf(scene::Scene& scene, std::size_t body, double& time_s) {
  constexpr std::size_t kTouches = 4000;
  const scene::Mesh& mesh = scene.mesh(body);
  const std::size_t every = std::max<std::size_t>(1, mesh.triangles().size() / kTouches);
  const double deep_mm = 0.5 * mesh.report().mean_edge_mm;
  std::vector<double> ns;
  for (std::size_t t = 0; t < mesh.triangles().size(); t += every) {
    const auto v = mesh.vertices();
    const scene::Triangle& corners = mesh.triangles()[t];
    const Vec3 middle = (1.0 / 3.0) * (v[corners[0]] + v[corners[1]] + v[corners[2]]);
    const Vec3 probe = middle - deep_mm * mesh.triangleNormal(static_cast<std::uint32_t>(t));
    time_s += 1e-3;
    const Vec3 at = scene.placement(body).toScene(probe, time_s);
    const auto start = std::chrono::steady_clock::now();
    static_cast<void>(scene.step(at, time_s));
    ns.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
  }
  return quantiles(ns);
}

nlohmann::ordered_json explanationOf(const scene::ContactChoiceReport& choice) {
  nlohmann::ordered_json json = {
      {"accuracy_met", choice.met}, {"depth_mm", choice.depth_mm}, {"places", choice.places}};
  for (const scene::ModelTrial& trial : choice.trials) {
    const std::string model(scene::kContactModels[static_cast<std::size_t>(trial.model)]);
    json[model + "_error_percent"] = 100.0 * trial.mean_error;
    json[model + "_through_percent"] = 100.0 * trial.pushes_through;
  }
  return json;
}

nlohmann::ordered_json explanationOf(const scene::SoftChoiceReport& choice) {
  nlohmann::ordered_json json = {{"accuracy_met", choice.met}, {"depth_mm", choice.depth_mm}};
  for (const scene::SoftTrial& trial : choice.trials) {
    json[fmt::format("{}_points_error_percent", trial.most_points)] = 100.0 * trial.mean_error;
  }
  return json;
}

void explain(const ExplainOptions& options) {
  const scene::LoadedScene file = valueOrFail(sim::openScene(options.scene));
  const auto start = std::chrono::steady_clock::now();
  const std::vector<scene::BodyChoice> choices = valueOrFail(scene::chooseModels(file));
  scene::Scene scene = valueOrFail(buildScene(file, modelsOf(choices)));
  nlohmann::ordered_json json = {
      {"scene", file.description.settings.name},
      {"digest", digestOf(file)},
      {"built_in_s", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()},
      {"memory_bytes", scene.bytes()},
      {"bodies", nlohmann::ordered_json::array()}};
  double time_s = 0.0;
  for (std::size_t i = 0; i < scene.bodies(); ++i) {
    const scene::BodyDescription& body = file.description.bodies[i];
    const Quantiles cost = costOf(scene, i, time_s);
    nlohmann::ordered_json to = {{"name", body.name},
                                 {"triangles", scene.mesh(i).triangles().size()},
                                 {"vertices", scene.mesh(i).vertices().size()}};
    if (const scene::BodyContact* rigid = scene.contact(i)) {
      to["contact"] = scene::kContactModels[static_cast<std::size_t>(rigid->settings().model)];
      to["radius_mm"] = rigid->settings().radius_mm;
      to["reach_mm"] = rigid->settings().reach_mm;
    } else {
      to["contact"] = "soft";
      to["finger_mm"] = scene.soft(i)->finger_mm();
      const std::size_t most = choices[i].model.resolution.most_points;
      to["most_points_awake"] = std::min(most, scene.mesh(i).vertices().size());
    }
    to["stiffness_N_per_mm"] = body.stiffness_N_per_mm;
    to["memory_bytes"] = scene.bytes(i);
    to["step_median_ns"] = cost.p50;
    to["step_p99_ns"] = cost.p99;
    if (choices[i].contact) to["choice"] = explanationOf(*choices[i].contact);
    if (choices[i].soft) to["choice"] = explanationOf(*choices[i].soft);
    json["bodies"].push_back(std::move(to));
  }
  json["gestures"] = nlohmann::ordered_json::array();
  if (file.description.swords) json["gestures"].push_back("swords");
  if (file.description.ball) json["gestures"].push_back("ball");
  if (file.description.palpation) json["gestures"].push_back("palpation");
  if (options.json) {
    printJson(json);
    return;
  }
  const nlohmann::ordered_json bodies = json["bodies"], gestures = json["gestures"];
  json.erase("bodies");
  json.erase("gestures");
  json["gestures"] =
      gestures.empty() ? "none" : fmt::format("{}", fmt::join(gestures.get<std::vector<std::string>>(), ", "));
  printValues(json, false);
  for (const auto& body : bodies) {
    std::cout << '\n';
    printValues(body, false);
  }
}

template <class Parameters>
void printKeys(std::string_view module) {
  Parameters parameters;
  std::cout << "\n[" << module << "]\n\n| key | unit | range | default | meaning |\n|---|---|---|---|---|\n";
  for (const Parameter& each : bindParameters(parameters)) {
    const std::string_view key = each.id.substr(each.id.find('.') + 1);
    std::cout << fmt::format("| `{}` | {} | {} | {} | {} |\n", key, each.info.unit == "1" ? "" : each.info.unit,
                             describeRange(each), formatParameter(each), each.info.help);
  }
}

}  // namespace

void addSceneExplain(CLI::App& scene) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App* command =
      scene.add_subcommand("explain", "What a scene file will be: bodies, models, memory, and the cost of a step");
  command->add_option("scene", options->scene, "Scene file, or the name of a scene that comes along")->required();
  command->add_flag("--json", options->json, "As JSON");
  command->callback([options] { explain(*options); });
}

void addSceneKeys(CLI::App& scene) {
  CLI::App* command = scene.add_subcommand("keys", "The tables and keys of a scene file, in Markdown");
  command->callback([] {
    printKeys<scene::SceneSettings>("scene");
    printKeys<scene::BodyDescription>("[body]");
    printKeys<scene::SwordParameters>("swords");
    printKeys<scene::FencingParameters>("fencing");
    printKeys<scene::BallParameters>("ball");
    printKeys<scene::ServeParameters>("serve");
    printKeys<scene::PalpationParameters>("palpation");
    printKeys<scene::PlaneParameters>("plane");
  });
}

}  // namespace fyd::cli
