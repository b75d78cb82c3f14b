// The paper's Table 1 in numbers: the force of each contact model for the same gesture, against the exact surface.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/cost_picture.h"
#include "app/bench/parts/scene_bumpy_plane.h"
#include "app/bench/parts/table.h"
#include "core/scene/contact/contact.h"
#include "core/scene/mesh/nearest_point.h"
#include "core/scene/mesh/vector.h"
#include "core/signal/welch.h"

namespace fyd::bench {
namespace scene_contact_rows {
namespace {

using namespace scene;

int steps() { return wholeOrQuick(60'000, 2'000); }
constexpr double kDepth_mm = 1.0;
constexpr double kSpeed_mm_s = 110.0;
constexpr double kStiffness_N_per_mm = 0.5;
constexpr double kRattle_Hz = 20.0;
constexpr double kBall_mm = 30.0;

/// A gesture and the force that the surface itself would give: a haptic point at a known depth under a known place.
struct Gesture {
  std::vector<Vec3> probe_mm;
  std::vector<Vec3> force_N;
};

Gesture onBumpyPlane() {
  Gesture gesture;
  gesture.probe_mm = underBumpyPlane(steps(), kSpeed_mm_s, kDepth_mm);
  // The same places, at the surface: their difference is the normal.
  const std::vector<Vec3> above = underBumpyPlane(steps(), kSpeed_mm_s, 0.0);
  for (std::size_t i = 0; i < above.size(); ++i) {
    gesture.force_N.push_back(kStiffness_N_per_mm * (above[i] - gesture.probe_mm[i]));
  }
  return gesture;
}

/// A sphere made by projecting a cube's faces; 12 n² triangles.
TriangleSoup sphere(int n) {
  TriangleSoup soup;
  const auto put = [&soup, n](std::array<int, 3> at) {
    const auto real = [n](int i) { return std::tan(std::numbers::pi / 4.0 * i / n); };
    soup.vertices.push_back(kBall_mm * unit({real(at[0]), real(at[1]), real(at[2])}));
    return static_cast<std::uint32_t>(soup.vertices.size() - 1);
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {-n, n}) {
      for (int i = -n; i < n; i += 2) {
        for (int j = -n; j < n; j += 2) {
          const auto corner = [&](int a, int b) {
            std::array<int, 3> at{};
            at[axis] = side;
            at[(axis + 1) % 3] = a;
            at[(axis + 2) % 3] = b;
            return put(at);
          };
          const std::uint32_t a = corner(i, j), b = corner(i + 2, j), c = corner(i + 2, j + 2), d = corner(i, j + 2);
          const bool out = side > 0;
          soup.triangles.push_back(out ? Triangle{a, b, c} : Triangle{a, c, b});
          soup.triangles.push_back(out ? Triangle{a, c, d} : Triangle{a, d, c});
        }
      }
    }
  }
  return soup;
}

Gesture onSphere() {
  Gesture gesture;
  for (int i = 0; i < steps(); ++i) {
    const double way = 1e-3 * kSpeed_mm_s * i / kBall_mm;
    const double turn = way, tilt = 1.2 * std::sin(0.17 * way);
    const Vec3 out = {std::cos(turn) * std::cos(tilt), std::sin(turn) * std::cos(tilt), std::sin(tilt)};
    gesture.probe_mm.push_back((kBall_mm - kDepth_mm) * out);
    gesture.force_N.push_back(kStiffness_N_per_mm * kDepth_mm * out);
  }
  return gesture;
}

/// RMS of a force above 20 Hz, all axes together.
double rattle(const std::vector<Vec3>& force) {
  double sum = 0.0;
  for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    std::vector<double> signal;
    signal.reserve(force.size());
    for (const Vec3& f : force) signal.push_back(f.*axis);
    const signal::Spectrum spectrum = signal::welch(signal, 1000.0, 1000);
    for (std::size_t k = 0; k < spectrum.density.size(); ++k) {
      if (spectrum.frequency_Hz(k) >= kRattle_Hz) sum += spectrum.density[k] * spectrum.resolution_Hz;
    }
  }
  return std::sqrt(sum);
}

double largestStep(const std::vector<Vec3>& force) {
  double largest = 0.0;
  for (std::size_t i = 1; i < force.size(); ++i) largest = std::max(largest, length(force[i] - force[i - 1]));
  return largest;
}

struct Model {
  const char* name = "";
  const char* paper = "";
  ContactSettings settings;
};
const std::array<Model, 5> kModels = {
    {{"nodes", "vertices", {.model = ContactModel::nodes}},
     {"facet", "one polygon: discontinuous between polygons", {.model = ContactModel::facet}},
     {"vicinity", "polygon and vicinity: smooth, the best", {.model = ContactModel::vicinity}},
     {"proxy", "(not in the paper)", {.model = ContactModel::proxy}},
     {"proxy, 1 mm", "(not in the paper)", {.model = ContactModel::proxy, .radius_mm = 1.0}}}};

void measure(Table& table, CostPanel& panel, const char* surface, const TriangleSoup& soup, const Gesture& gesture) {
  const Mesh mesh = *Mesh::build(soup);
  const TriangleTree tree(mesh);
  const WalkableMesh walkable(tree);
  const double true_step_N = largestStep(gesture.force_N), true_rattle_N = rattle(gesture.force_N);
  for (const Model& model : kModels) {
    BodyContact contact(tree, {.stiffness_N_per_mm = kStiffness_N_per_mm}, model.settings);
    NearestPoint nearest(walkable);
    // A proxy comes in from outside, and a finger of finite radius touches earlier by as much.
    const double shift = model.settings.model == ContactModel::proxy ? model.settings.radius_mm : 0.0;
    std::vector<Vec3> force;
    std::vector<double> ns;
    double error = 0.0;
    for (std::size_t i = 0; i < gesture.probe_mm.size(); ++i) {
      const Vec3 out = unit(gesture.force_N[i]);
      const Vec3 probe = gesture.probe_mm[i] + shift * out;
      if (i == 0) {
        const Vec3 before = probe + (2.0 * kDepth_mm + shift) * out;
        static_cast<void>(contact.touch(before, {}, nearest.find(before)));
      }
      const auto start = std::chrono::steady_clock::now();
      const Contact touch = contact.touch(probe, {}, nearest.find(probe));
      ns.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
      force.push_back(touch.force_N);
      error += length(touch.force_N - gesture.force_N[i]) / length(gesture.force_N[i]);
    }
    const Quantiles cost = quantiles(ns);
    const double percent = 100.0 * error / static_cast<double>(force.size());
    panel.points.push_back({model.name, cost.p50, percent});
    panel.title = fmt::format("{}, {} triangles", surface, mesh.triangles().size());
    const bool baseline = model.settings.model == ContactModel::facet;
    table.rows.push_back({surface, std::to_string(mesh.triangles().size()),
                          std::string(model.name) + (baseline ? " (baseline)" : ""), model.paper, number(percent),
                          number(largestStep(force) / true_step_N), number(1e3 * rattle(force)),
                          number(rattle(force) / true_rattle_N), number(cost.p50), number(cost.p99),
                          number(static_cast<double>(contact.bytes() + walkable.bytes() + tree.bytes()) / 1e6)});
  }
}

}  // namespace
}  // namespace scene_contact_rows

Table bench_scene_contact() {
  using namespace scene_contact_rows;
  Table table{
      .subject = "scene_contact",
      .title = "Contact models on the same gesture, 1 mm deep at 110 mm/s (the paper's Table 1 in numbers)",
      .columns = {{"surface", Role::group},
                  {"triangles", Role::group},
                  {"model", Role::method},
                  "the paper's words",
                  {"mean force error", "%", Role::error},
                  "largest step of force / the surface's own",
                  {"force above 20 Hz RMS", "mN"},
                  "the same / the surface's own",
                  {"step median", "ns", Role::cost},
                  {"step p99", "ns"},
                  {"memory", "MB"}},
      .rows = {},
      .notes = {"Truth is the surface itself, without triangles: z = 2 mm · sin(2πx/20 mm) · sin(2πy/20 mm), and a "
                "sphere of 30 mm; 0.5 N/mm. A proxy of finite radius goes along the same gesture, its radius "
                "farther out; under the bumpy plane's hollows it is truly another surface that it feels."}};
  const Gesture bumpy = onBumpyPlane();
  std::vector<CostPanel> panels(4);
  measure(table, panels[0], "sphere", sphere(29), onSphere());
  constexpr std::array<int, 3> kSizes = {71, 224, 707};
  for (std::size_t i = 0; i < wholeOrQuick<std::size_t>(kSizes.size(), 1); ++i) {
    measure(table, panels[i + 1], "bumpy plane", bumpyPlane(kSizes[i]), bumpy);
  }
  std::erase_if(panels, [](const CostPanel& panel) { return panel.points.empty(); });
  writeBeside("scene_contact.svg", errorAgainstCost(panels, {.least = 30.0,
                                                             .most = 50'000.0,
                                                             .errors = {1e-4, 1e-3, 0.01, 0.1, 1.0, 10.0, 100.0},
                                                             .marked_error = 1.0,
                                                             .logarithmic = true,
                                                             .unit = " %",
                                                             .marked = "vicinity"}));
  return table;
}

}  // namespace fyd::bench
