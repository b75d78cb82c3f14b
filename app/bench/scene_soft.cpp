// Deformable bodies: the force of a press that slides and its cost, beside the same body with every point awake and at
// a fiftieth of the step, which is the truth here.
#include <cmath>
#include <memory>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/scene_bumpy_plane.h"
#include "app/bench/parts/table.h"
#include "core/scene/mesh/vector.h"
#include "core/scene/soft/soft_body.h"

namespace fyd::bench {
namespace scene_soft_rows {
namespace {

using namespace scene;

int steps() { return wholeOrQuick(600, 150); }

/// Down to 1.5 mm below the surface and along it.
Vec3 hand(int step) {
  const double t = 1e-3 * step;
  const double x = 6.0 * std::sin(2.0 * t), y = 0.3;
  return {x, y, bumpyHeight(x, y) + 0.2 - 0.85 * (1.0 - std::cos(6.0 * t))};
}

struct Run {
  std::vector<Vec3> force_N;
  std::vector<double> ns;
  std::size_t awake = 0;
};

Run press(const TriangleTree& tree, const SoftMaterial& material, const SoftResolution& resolution) {
  auto body = SoftBody::build(tree, material, resolution);
  Run run;
  if (!body) return run;
  for (int i = 0; i < steps(); ++i) {
    const auto start = std::chrono::steady_clock::now();
    const SoftContact& contact = body->step(1e-3, hand(i));
    run.ns.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
    run.force_N.push_back(contact.force_N);
    run.awake = std::max(run.awake, body->awake().size());
  }
  return run;
}

void measure(Table& table, int n) {
  const Mesh mesh = *Mesh::build(bumpyPlane(n));
  const TriangleTree tree(mesh);
  const SoftMaterial material{
      .mass_kg = 0.05, .rigidity_N_per_mm = 0.5, .viscosity_Ns_per_mm = 0.01, .spread_mm = 3.0, .finger_mm = 4.0};
  const Run truth =
      press(tree, material, {.border = 1e-6, .longest_step_s = 2e-5, .most_parts = 50, .tolerance = 1e-7});
  double largest_N = 0.0;
  for (const Vec3& force : truth.force_N) largest_N = std::max(largest_N, length(force));
  const auto add = [&](const char* name, const SoftResolution& resolution) {
    Run run = press(tree, material, resolution);
    double worst_N = 0.0;
    for (std::size_t i = 0; i < run.force_N.size(); ++i) {
      worst_N = std::max(worst_N, length(run.force_N[i] - truth.force_N[i]));
    }
    const Quantiles cost = quantiles(run.ns);
    table.rows.push_back({std::to_string(mesh.triangles().size()), name, std::to_string(run.awake),
                          number(1e-3 * cost.p50), number(1e-3 * cost.p99), number(100.0 * worst_N / largest_N)});
  };
  add("every point awake (baseline)", {.border = 1e-6});
  add("default", {});
  add("at most 300 points", {.most_points = 300});
  add("steps of 0.25 ms", {.longest_step_s = 2.5e-4});
}

}  // namespace
}  // namespace scene_soft_rows

Table bench_scene_soft() {
  Table table{
      .subject = "scene_soft",
      .title = "A deformable body, pressed and slid along",
      .columns = {{"triangles", Role::group},
                  {"body", Role::method},
                  "points awake",
                  {"step median", "µs", Role::cost},
                  {"step p99", "µs"},
                  {"worst force error", "% of the largest", Role::error}},
      .rows = {},
      .notes = {"The bumpy plane of the contact benches as a membrane on a foundation, 0.5 N/mm, a finger of 4 "
                "mm, 1.5 mm deep and 5.6 mm along. Truth: every point awake, steps of 20 µs, equations solved to "
                "1e-7. It is the same equations, so the figures are of time step, border and solver, not of "
                "the material law."}};
  for (const int n : wholeOrQuick(std::vector<int>{35, 71}, std::vector<int>{30})) scene_soft_rows::measure(table, n);
  return table;
}

}  // namespace fyd::bench
