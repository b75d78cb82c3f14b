// fyd scene check|run|fence|keys|explain: haptic scenes without a touchpad.
#include <algorithm>
#include <chrono>
#include <iostream>

#include "app/cli/parts/command.h"
#include "app/cli/scene/scene_cli.h"
#include "core/scene/mesh/mesh_text.h"
#include "core/scene/mesh/nearest_point.h"
#include "core/sim/scene_file.h"

namespace fyd::cli {
namespace {

struct CheckOptions {
  std::string mesh;
  std::string unit = "mm";
  bool json = false;
};

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

nlohmann::ordered_json jsonOf(const Vec3& v) { return {jsonNumber(v.x), jsonNumber(v.y), jsonNumber(v.z)}; }

/// Sentences on what was repaired in the mesh, what was not, and what that means for touching it.
std::vector<std::string> remarksOn(const scene::MeshReport& r) {
  std::vector<std::string> out;
  const auto add = [&out](std::size_t count, const char* what) {
    if (count > 0) out.push_back(fmt::format("{} {}", count, what));
  };
  add(r.not_finite, "vertices are no numbers: their triangles were left out");
  add(r.duplicate_vertices, "vertices stood where another one stands: merged");
  add(r.degenerate_triangles, "triangles without an area: left out");
  add(r.duplicate_triangles, "triangles of the same three vertices as another one: left out");
  add(r.flipped_triangles, "triangles faced the other way than their neighbours: turned over");
  add(r.holes, "holes: the mesh is open, and pushes towards its outside only");
  add(r.non_manifold_edges, "edges of more than two triangles: each is treated as a rim there");
  add(r.inside_out, "closed pieces have triangles that face inwards: not mended; a finger is pushed inwards");
  return out;
}

void check(const CheckOptions& options) {
  const auto unit = std::ranges::find(scene::kLengthUnits, options.unit) - scene::kLengthUnits.begin();
  const auto start = std::chrono::steady_clock::now();
  const scene::Mesh mesh = valueOrFail(sim::openMesh(options.mesh, static_cast<scene::LengthUnit>(unit)));
  const double read_s = secondsSince(start);
  const auto building = std::chrono::steady_clock::now();
  const scene::TriangleTree tree(mesh);
  const double tree_s = secondsSince(building);
  const scene::MeshReport& r = mesh.report();
  nlohmann::ordered_json json = {
      {"mesh", options.mesh},
      {"unit", options.unit},
      {"vertices", r.vertices},
      {"triangles", r.triangles},
      {"pieces", r.pieces},
      {"lowest_mm", jsonOf(r.lowest_mm)},
      {"highest_mm", jsonOf(r.highest_mm)},
      {"shortest_edge_mm", r.shortest_edge_mm},
      {"mean_edge_mm", r.mean_edge_mm},
      {"longest_edge_mm", r.longest_edge_mm},
      {"area_mm2", r.area_mm2},
      {"volume_mm3", r.volume_mm3},
      {"vertices_not_finite", r.not_finite},
      {"duplicate_vertices", r.duplicate_vertices},
      {"degenerate_triangles", r.degenerate_triangles},
      {"duplicate_triangles", r.duplicate_triangles},
      {"flipped_triangles", r.flipped_triangles},
      {"rim_edges", r.rim_edges},
      {"holes", r.holes},
      {"non_manifold_edges", r.non_manifold_edges},
      {"inside_out_pieces", r.inside_out},
      {"read_s", read_s},
      {"tree_s", tree_s},
      {"memory_bytes", mesh.bytes() + tree.bytes()},
  };
  if (options.json) json["remarks"] = remarksOn(r);
  printValues(json, options.json);
  if (!options.json) {
    for (const std::string& remark : remarksOn(r)) std::cout << remark << '\n';
  }
}

}  // namespace

void add_scene(CLI::App& app) {
  CLI::App* command = app.add_subcommand("scene", "Haptic scenes: meshes checked, scenes explained and run");
  command->require_subcommand(1);
  auto options = std::make_shared<CheckOptions>();
  CLI::App* check_command =
      command->add_subcommand("check", "What a mesh holds, and what had to be mended to touch it");
  check_command->add_option("mesh", options->mesh, "OBJ, STL or PLY file")
      ->required()
      ->check(goodFor(scene::meshFormatOf));
  check_command->add_option("--unit", options->unit, "Of its coordinates")
      ->check(CLI::IsMember(std::vector<std::string>(scene::kLengthUnits.begin(), scene::kLengthUnits.end())))
      ->capture_default_str();
  check_command->add_flag("--json", options->json, "As JSON");
  check_command->callback([options] { check(*options); });
  addSceneExplain(*command);
  addSceneRun(*command);
  addSceneFence(*command);
  addSceneKeys(*command);
}

}  // namespace fyd::cli
