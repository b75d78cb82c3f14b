// The cost of bodies that are not touched: one body under the finger, and many elsewhere.
#include <algorithm>
#include <cmath>
#include <memory>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/scene_bumpy_plane.h"
#include "app/bench/parts/table.h"
#include "core/scene/scene.h"

namespace fyd::bench {
namespace scene_bodies_rows {
namespace {

using namespace scene;

int steps() { return wholeOrQuick(20'000, 500); }
constexpr int kRounds = 5;  // alternating, so that a machine that slows down affects all cases alike

struct Counted {
  std::size_t bodies;
  std::unique_ptr<Scene> scene;
  std::vector<double> ns;
};

Counted withBodies(std::size_t bodies, const std::shared_ptr<const SearchedMesh>& mesh) {
  SceneDescription description;
  for (std::size_t i = 0; i < bodies; ++i) {
    BodyDescription& body = description.bodies.emplace_back();
    if (i == 0) continue;
    const std::size_t row = i / 10, column = i % 10;
    for (const double at : {1000.0 + 200.0 * static_cast<double>(column), 200.0 * static_cast<double>(row), 0.0}) {
      static_cast<void>(body.position_mm.push(at));
    }
  }
  return {
      bodies,
      std::make_unique<Scene>(*Scene::build(description, std::vector(bodies, mesh), std::vector(bodies, BodyModel{}))),
      {}};
}

}  // namespace
}  // namespace scene_bodies_rows

Table bench_scene_bodies() {
  using namespace scene_bodies_rows;
  Table table{.subject = "scene_bodies",
              .title = "A step with bodies that sleep",
              .columns = {{"bodies", Role::method},
                          "of them awake",
                          {"step median", "ns", Role::cost},
                          "against one body",
                          {"memory", "MB"}},
              .rows = {},
              .notes = {std::to_string(steps()) +
                        " steps over a bumpy plane of 10 000 triangles, five times in turn; the others are as large, "
                        "share its mesh and are at least 850 mm away. Each has search and surface of its own."}};
  const auto mesh = std::make_shared<const SearchedMesh>(*Mesh::build(bumpyPlane(71)));
  const std::vector<Vec3> path = underBumpyPlane(steps(), 110.0, 1.0);
  std::vector<Counted> all;
  for (const std::size_t bodies : {1U, 2U, 10U, 100U}) all.push_back(withBodies(bodies, mesh));
  double time_s = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    for (Counted& each : all) {
      for (const Vec3& at : path) {
        time_s += 1e-3;
        const auto start = std::chrono::steady_clock::now();
        static_cast<void>(each.scene->step(at, time_s));
        each.ns.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
      }
    }
  }
  double one_ns = 0.0;
  for (Counted& each : all) {
    const double median_ns = quantiles(each.ns).p50;
    if (each.bodies == 1) one_ns = median_ns;
    table.rows.push_back({std::to_string(each.bodies) + (each.bodies == 1 ? " (baseline)" : ""),
                          std::to_string(each.scene->awake()), number(median_ns), number(median_ns / one_ns),
                          number(static_cast<double>(each.scene->bytes()) / 1e6)});
  }
  return table;
}

}  // namespace fyd::bench
