// Meshes, the contact of a point with them, and scenes.
#include "app/python/scenes.h"

#include <fmt/format.h>

#include "app/python/parameters.h"
#include "core/scene/mesh/mesh_text.h"
#include "core/sim/scene_file.h"

namespace fyd::python {
namespace {

using scene::Mesh;

/// A mesh and its search; the tree points to the mesh.
struct Searched : std::enable_shared_from_this<Searched> {
  explicit Searched(Mesh from) : mesh(std::move(from)), tree(mesh) {}
  Mesh mesh;
  scene::TriangleTree tree;
};
using MeshOwner = std::shared_ptr<Searched>;

scene::LengthUnit unitNamed(const std::string& name) {
  const auto found = std::find(scene::kLengthUnits.begin(), scene::kLengthUnits.end(), name);
  if (found == scene::kLengthUnits.end())
    throw Refusal{fmt::format("unit: '{}'; expected one of {}", name, fmt::join(scene::kLengthUnits, ", "))};
  return static_cast<scene::LengthUnit>(found - scene::kLengthUnits.begin());
}

/// Triangles as numbers of any kind: as integers, NumPy would cut those of a list that are not whole.
MeshOwner meshOf(const Numbers& vertices_mm, const Numbers& triangles) {
  const auto vertices = vectors(vertices_mm, "vertices_mm");
  if (triangles.ndim() != 2 || triangles.shape(1) != 3)
    throw Refusal{fmt::format("triangles: shape {}; expected (n, 3)", shapeOf(triangles))};
  scene::TriangleSoup soup;
  soup.vertices.assign(vertices.begin(), vertices.end());
  for (py::ssize_t i = 0; i < triangles.shape(0); ++i) {
    scene::Triangle triangle{};
    for (py::ssize_t corner = 0; corner < 3; ++corner) {
      const double vertex = triangles.at(i, corner);
      if (!(vertex >= 0.0 && vertex < static_cast<double>(vertices.size())) || std::floor(vertex) != vertex)
        throw Refusal{fmt::format("triangles: row {} names vertex {}; expected one of 0 to {}", i, vertex,
                                  static_cast<std::int64_t>(vertices.size()) - 1)};
      triangle[static_cast<std::size_t>(corner)] = static_cast<std::uint32_t>(vertex);
    }
    soup.triangles.push_back(triangle);
  }
  const OthersGoOn others_go_on;
  return std::make_shared<Searched>(valid(Mesh::build(std::move(soup))));
}

struct Touching {
  MeshOwner mesh;
  scene::BodyContact contact;
};
using ContactOwner = Shared<Touching>;

/// Of a body's keys in a scene file, those that say how it is touched.
constexpr std::array<std::string_view, 8> kContactKeys = {
    "contact",          "stiffness_N_per_mm", "damping_Ns_per_mm", "static_friction",
    "kinetic_friction", "radius_mm",          "depth_mm",          "soft"};

/// "stiffness_N_per_mm=0.8" is the key body.stiffness_N_per_mm of a scene file, with its range.
std::unique_ptr<ContactOwner> contactOf(const MeshOwner& mesh, const py::kwargs& keys) {
  scene::BodyDescription body;
  body.contact = scene::ContactChoice::vicinity;
  const std::vector<Parameter> bound = bindParameters(body);
  for (const auto& [name, value] : keys) {
    const std::string id = idOf(name);
    if (std::ranges::find(kContactKeys, id) == kContactKeys.end())
      throw Refusal{
          fmt::format("{}: a contact has no such key; expected one of {}", id, fmt::join(kContactKeys, ", "))};
    assign(*findParameter(bound, "body." + id), value);
  }
  if (body.soft) throw Refusal{"soft: a soft body is touched in a scene only"};
  const bool chosen = body.contact == scene::ContactChoice::automatic;
  if (chosen) throw Refusal{"contact: automatic is chosen in a scene only; expected nodes, facet, vicinity or proxy"};
  // The choice "automatic" stands before the models.
  const auto model = static_cast<scene::ContactModel>(static_cast<int>(body.contact) - 1);
  return std::make_unique<ContactOwner>(
      Touching{mesh, scene::BodyContact(mesh->tree,
                                        {.stiffness_N_per_mm = body.stiffness_N_per_mm,
                                         .damping_Ns_per_mm = body.damping_Ns_per_mm,
                                         .static_friction = body.static_friction,
                                         .kinetic_friction = body.kinetic_friction},
                                        {.model = model, .radius_mm = body.radius_mm, .reach_mm = body.depth_mm})});
}

/// What a path of a haptic point felt.
struct Felt {
  std::vector<Vec3> force_N, proxy_mm, normal;
  std::vector<double> depth_mm, stiffness_N_per_mm, texture_g;
  std::vector<std::uint8_t> touching;
  std::vector<std::int64_t> body;

  void add(const scene::SceneTouch& touch, double texture) {
    force_N.push_back(touch.force_N), proxy_mm.push_back(touch.proxy_mm), normal.push_back(touch.normal);
    depth_mm.push_back(touch.depth_mm), stiffness_N_per_mm.push_back(touch.stiffness_N_per_mm);
    texture_g.push_back(texture), touching.push_back(touch.touching ? 1 : 0);
    body.push_back(touch.body == scene::kNoBody ? -1 : static_cast<std::int64_t>(touch.body));
  }
  [[nodiscard]] py::dict asDict() && {
    py::dict out;
    out["touching"] = arrayOf(std::move(touching)).attr("view")("bool");
    out["force_N"] = arrayOf(std::move(force_N));
    out["proxy_mm"] = arrayOf(std::move(proxy_mm));
    out["normal"] = arrayOf(std::move(normal));
    out["depth_mm"] = arrayOf(std::move(depth_mm));
    out["stiffness_N_per_mm"] = arrayOf(std::move(stiffness_N_per_mm));
    out["texture_g"] = arrayOf(std::move(texture_g));
    out["body"] = arrayOf(std::move(body));
    return out;
  }
};

py::tuple tupleOf(const Vec3& v) { return py::make_tuple(v.x, v.y, v.z); }

std::span<const double> timesFor(const Numbers& time_s, std::size_t rows) {
  const auto times = vector(time_s, "time_s");
  if (times.size() != rows) throw Refusal{fmt::format("time_s: {} values for {} rows of probe_mm", times.size(), rows)};
  return times;
}

void addMeshes(py::module_& module) {
  py::class_<Searched, MeshOwner>(module, "Mesh", "A triangle mesh that can be touched.")
      .def(py::init(&meshOf), py::arg("vertices_mm"), py::arg("triangles"),
           "Of vertices [mm], shape (n, 3), and triangles, three numbers of vertices each, counter-clockwise from "
           "outside. "
           "Mends what can be mended.")
      .def_static(
          "open",
          [](const py::object& path, const std::string& unit) {
            const auto length = unitNamed(unit);
            const std::string file = pathOf(path);
            const OthersGoOn others_go_on;
            return std::make_shared<Searched>(done(sim::openMesh(file, length)));
          },
          py::arg("path"), py::arg("unit") = "mm", "An OBJ, STL or PLY file; `unit` of its lengths: mm, cm, m or in.")
      .def_property_readonly(
          "vertices_mm",
          [](Searched& mesh) {  // a reference: None is no mesh, but a MeshOwner of it would be null
            const auto vertices = mesh.mesh.vertices();
            auto* kept = new MeshOwner(mesh.shared_from_this());
            const py::capsule owner(kept, [](void* p) { delete static_cast<MeshOwner*>(p); });
            py::array_t<double> out({static_cast<py::ssize_t>(vertices.size()), py::ssize_t{3}},
                                    reinterpret_cast<const double*>(vertices.data()), owner);
            out.attr("flags").attr("writeable") = false;
            return out;
          },
          "Shape (n, 3), the mesh's own memory [mm]")
      .def_property_readonly(
          "triangles",
          [](Searched& mesh) {
            const auto triangles = mesh.mesh.triangles();
            auto* kept = new MeshOwner(mesh.shared_from_this());
            const py::capsule owner(kept, [](void* p) { delete static_cast<MeshOwner*>(p); });
            py::array_t<std::uint32_t> out({static_cast<py::ssize_t>(triangles.size()), py::ssize_t{3}},
                                           reinterpret_cast<const std::uint32_t*>(triangles.data()), owner);
            out.attr("flags").attr("writeable") = false;
            return out;
          },
          "Numbers of vertices, shape (n, 3), the mesh's own memory [—]")
      .def_property_readonly(
          "area_mm2", [](const Searched& mesh) { return mesh.mesh.report().area_mm2; }, "[mm²]")
      .def_property_readonly(
          "volume_mm3", [](const Searched& mesh) { return mesh.mesh.report().volume_mm3; }, "Of closed pieces [mm³]")
      .def_property_readonly(
          "holes", [](const Searched& mesh) { return mesh.mesh.report().holes; },
          "Closed loops of edges with one triangle [1]")
      .def_property_readonly(
          "pieces", [](const Searched& mesh) { return mesh.mesh.report().pieces; }, "Not connected [1]");

  py::class_<ContactOwner>(module, "Contact", "One body and one haptic point that touches it.")
      .def(py::init(&contactOf), py::arg("mesh").none(false),
           "With the keys of a body of a scene file, such as contact=\"proxy\", stiffness_N_per_mm=0.8 [N/mm], "
           "radius_mm [mm].")
      .def(
          "run",
          [](ContactOwner& owner, const Numbers& probe_mm, double period_s) {
            const auto path = vectors(probe_mm, "probe_mm");
            if (!(period_s > 0.0)) throw Refusal{fmt::format("period_s: {}; expected more than 0", period_s)};
            std::vector<Vec3> force(path.size());
            owner.run([&](Touching& each) {
              for (std::size_t i = 0; i < path.size(); ++i) {
                const Vec3 velocity = i == 0 ? Vec3() : (1.0 / period_s) * (path[i] - path[i - 1]);
                force[i] = each.contact.touch(path[i], velocity, each.mesh->tree.nearest(path[i])).force_N;
              }
            });
            return arrayOf(std::move(force));
          },
          py::arg("probe_mm"), py::arg("period_s") = 0.001,
          "The force [N], shape (n, 3), on a point that goes this way [mm], shape (n, 3), one place each period_s [s]. "
          "A place that is not finite touches nothing. A proxy goes on where the last call left it: for another way, "
          "reset() first. Other threads go on meanwhile.")
      .def(
          "reset", [](ContactOwner& owner) { owner.run([](Touching& each) { each.contact.restore({}); }); },
          "Back to before the first touch. Units: none.");
}

}  // namespace

void addScenes(py::module_& module) {
  addMeshes(module);
  using scene::SceneTouch;
  py::class_<SceneTouch>(module, "SceneTouch", "What the haptic point of a scene feels.")
      .def_readonly("touching", &SceneTouch::touching, "Whether anything is touched [—]")
      .def_property_readonly(
          "force_N", [](const SceneTouch& touch) { return tupleOf(touch.force_N); }, "On the haptic point [N]")
      .def_property_readonly(
          "proxy_mm", [](const SceneTouch& touch) { return tupleOf(touch.proxy_mm); },
          "Where it is held by what pushes most [mm]")
      .def_property_readonly(
          "normal", [](const SceneTouch& touch) { return tupleOf(touch.normal); }, "Of what pushes most, outwards [1]")
      .def_readonly("depth_mm", &SceneTouch::depth_mm, "How deep it is inside [mm]")
      .def_readonly("stiffness_N_per_mm", &SceneTouch::stiffness_N_per_mm,
                    "Along the force; 0: nothing is touched [N/mm]")
      .def_property_readonly(
          "body",
          [](const SceneTouch& touch) {
            return touch.body == scene::kNoBody ? -1 : static_cast<std::int64_t>(touch.body);
          },
          "Which body pushes most; −1: a gesture, or nothing [—]");
  py::class_<FeltScene>(module, "Scene", "A haptic scene as a finger feels it, step by step.")
      .def_static(
          "open",
          [](const py::object& path, double rate_Hz) {
            const double rate = checkedRate(rate_Hz);
            const std::string file = pathOf(path);
            const OthersGoOn others_go_on;
            return std::make_unique<FeltScene>(done(sim::openFeltScene(file, rate)));
          },
          py::arg("path"), py::arg("rate_Hz") = 1000.0,
          "A scene file with its meshes and stored surfaces, for steps at rate_Hz [Hz]; in a Pipeline that is its "
          "texture.sample_rate_Hz.")
      .def_property_readonly(
          "bodies",
          [](FeltScene& scene) {
            std::vector<std::string> out;
            for (const auto& body : scene.start()->loaded()->description.bodies) out.push_back(body.name);
            return out;
          },
          "Their names, in the order of the file [—]")
      .def(
          "step",
          [](FeltScene& scene, const Numbers& probe_mm, double time_s) {
            const Vec3 at = point(probe_mm, "probe_mm");
            return scene.step(at, time_s);
          },
          py::arg("probe_mm"), py::arg("time_s"),
          "The haptic point is at probe_mm [mm] at time_s [s]. A place or a time that is no number touches nothing; "
          "a time that is not after the last step's gives what was felt there.")
      .def(
          "run",
          [](FeltScene& scene, const Numbers& probe_mm, const Numbers& time_s) {
            const auto path = vectors(probe_mm, "probe_mm");
            const auto times = timesFor(time_s, path.size());
            Felt felt;
            scene.run(path, times, [&](const SceneTouch& touch, double texture_g) { felt.add(touch, texture_g); });
            return std::move(felt).asDict();
          },
          py::arg("probe_mm"), py::arg("time_s"),
          "A whole way [mm], shape (n, 3), at these times [s], each after the one before and after the last step; by "
          "name the columns of SceneTouch, in [N], [mm], [N/mm], and texture_g [g] of a finger that slides. Goes on "
          "where the last step ended: for another way from time 0, reset() first. Other threads go on meanwhile.")
      .def("reset", &FeltScene::reset, "Back to before the first step. Units: none.");
}

}  // namespace fyd::python
