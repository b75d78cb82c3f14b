#include "core/scene/contact/contact_choice.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/scene/contact/fitted_surface.h"
#include "core/scene/mesh/vector.h"
#include "core/scene/mesh/vertex_fans.h"

namespace fyd::scene {
namespace {

constexpr std::size_t kPlaces = 400;   // at least, on a mesh of so many triangles
constexpr std::size_t kLeftOut = 200;  // vertices, one at a time; likewise
constexpr double kForce_N = 1.0;
constexpr double kDeepestChoice = 0.02;        // of the mesh's diagonal
constexpr double kErrorRatioOfHalfEdge = 2.0;  // halving the edge length divides the error by this at least
constexpr double kThroughLimit = 0.01;         // of the places; more, and a wall is thin
constexpr int kRings = 4;                      // of vertices around the one left out

struct Place {
  Vec3 surface_mm, normal, probe_mm;
};

std::vector<Place> placesOn(const Mesh& mesh, double depth_mm) {
  std::vector<Place> out;
  const std::size_t every = std::max<std::size_t>(1, mesh.triangles().size() / kPlaces);
  for (std::size_t t = 0; t < mesh.triangles().size(); t += every) {
    const auto v = mesh.vertices();
    const Triangle& c = mesh.triangles()[t];
    // Places vary within the triangle: at its centre a facet's error is smallest.
    const double a = 0.1 + 0.8 * static_cast<double>(out.size() % 7) / 6.0;
    const double b = (1.0 - a) * (0.1 + 0.8 * static_cast<double>(out.size() % 5) / 4.0);
    const Vec3 at = a * v[c[0]] + b * v[c[1]] + (1.0 - a - b) * v[c[2]];
    const Vec3 normal = mesh.triangleNormal(static_cast<std::uint32_t>(t));
    out.push_back({at, normal, at - depth_mm * normal});
  }
  return out;
}

/// The mesh around a vertex, without it: its hole is closed by a fan of triangles.
/// @return nothing where the vertex is on a rim or not surrounded by one ring of triangles
std::optional<Mesh> withoutVertex(const Mesh& mesh, const VertexFans& fans, std::uint32_t left_out) {
  std::unordered_map<std::uint32_t, std::uint32_t> next;  // around the hole
  for (const std::uint32_t t : fans[left_out]) {
    const Triangle& c = mesh.triangles()[t];
    const std::size_t own = c[0] == left_out ? 0 : c[1] == left_out ? 1 : 2;
    if (!next.emplace(c[(own + 1) % 3], c[(own + 2) % 3]).second) return std::nullopt;
  }
  TriangleSoup patch;
  std::unordered_map<std::uint32_t, std::uint32_t> place;
  const auto placeOf = [&](std::uint32_t v) {
    const auto [found, isNew] = place.emplace(v, static_cast<std::uint32_t>(patch.vertices.size()));
    if (isNew) patch.vertices.push_back(mesh.vertices()[v]);
    return found->second;
  };
  const std::uint32_t start = next.begin()->first;
  std::uint32_t at = next.at(start);
  for (std::size_t i = 2; i < next.size(); ++i) {
    const auto following = next.find(at);
    if (following == next.end() || following->second == start) return std::nullopt;
    patch.triangles.push_back({placeOf(start), placeOf(at), placeOf(following->second)});
    at = following->second;
  }
  if (const auto closes = next.find(at); closes == next.end() || closes->second != start) return std::nullopt;
  std::unordered_map<std::uint32_t, int> ring{{left_out, 0}};
  std::vector<std::uint32_t> open{left_out};
  std::unordered_map<std::uint32_t, bool> taken;
  for (std::size_t i = 0; i < open.size(); ++i) {
    const int depth = ring[open[i]];
    if (depth == kRings) continue;
    for (const std::uint32_t t : fans[open[i]]) {
      const Triangle& c = mesh.triangles()[t];
      if (c[0] != left_out && c[1] != left_out && c[2] != left_out && taken.emplace(t, true).second) {
        patch.triangles.push_back({placeOf(c[0]), placeOf(c[1]), placeOf(c[2])});
      }
      for (const std::uint32_t v : c) {
        if (ring.emplace(v, depth + 1).second) open.push_back(v);
      }
    }
  }
  auto built = Mesh::build(std::move(patch));
  return built ? std::optional(std::move(*built)) : std::nullopt;
}

/// Estimated mean error of the fitted surface's force, as a share of the force.
double leaveOneOutError(const TriangleTree& tree, BodyContact& vicinity, double depth_mm) {
  const Mesh& mesh = tree.mesh();
  const VertexFans fans(mesh);
  const std::size_t every = std::max<std::size_t>(1, mesh.vertices().size() / kLeftOut);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < mesh.vertices().size(); v += static_cast<std::uint32_t>(every)) {
    const auto around = withoutVertex(mesh, fans, v);
    if (!around) continue;
    const Vec3 probe = mesh.vertices()[v] - depth_mm * mesh.vertexNormal(v);
    const Contact whole = vicinity.touch(probe, {}, tree.nearest(probe));
    if (!whole.touching) continue;
    const TriangleTree patch(*around);
    BodyContact without(patch, vicinity.surface(), vicinity.settings());
    const Contact guess = without.touch(probe, {}, patch.nearest(probe));
    sum += std::min(1.0, length(guess.force_N - whole.force_N) / length(whole.force_N));
    ++count;
  }
  // A mesh without a vertex between triangles is all creases and rims: there is nothing to fit.
  return count == 0 ? 0.0 : sum / static_cast<double>(count) / kErrorRatioOfHalfEdge;
}

}  // namespace

ContactChoiceReport chooseContact(const TriangleTree& tree, const Surface& surface, const ContactSettings& settings,
                                  double accuracy) {
  const MeshReport& mesh = tree.mesh().report();
  ContactChoiceReport out;
  out.depth_mm =
      std::min(kForce_N / surface.stiffness_N_per_mm, kDeepestChoice * length(mesh.highest_mm - mesh.lowest_mm));
  if (settings.reach_mm > 0.0) out.depth_mm = std::min(out.depth_mm, 0.5 * settings.reach_mm);
  const std::vector<Place> places = placesOn(tree.mesh(), out.depth_mm);
  out.places = places.size();
  Surface plain{.stiffness_N_per_mm = surface.stiffness_N_per_mm};
  const auto contactOf = [&](ContactModel model) {
    ContactSettings with = settings;
    with.model = model;
    return BodyContact(tree, plain, with);
  };
  BodyContact vicinity = contactOf(ContactModel::vicinity);
  std::vector<Contact> reference;
  reference.reserve(places.size());
  for (const Place& place : places)
    reference.push_back(vicinity.touch(place.probe_mm, {}, tree.nearest(place.probe_mm)));
  const double fit = leaveOneOutError(tree, vicinity, out.depth_mm);
  constexpr std::array<ContactModel, 4> kByCost = {ContactModel::facet, ContactModel::vicinity, ContactModel::proxy,
                                                   ContactModel::nodes};
  for (std::size_t m = 0; m < kByCost.size(); ++m) {
    ModelTrial& trial = out.trials[m];
    trial.model = kByCost[m];
    BodyContact contact = contactOf(trial.model);
    double sum = 0.0;
    std::size_t judged = 0, through = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Place& place = places[i];
      if (trial.model == ContactModel::proxy) {  // it must start outside
        contact.restore({});
        const Vec3 before = place.surface_mm + out.depth_mm * place.normal;
        static_cast<void>(contact.touch(before, {}, tree.nearest(before)));
      }
      const Contact touch = contact.touch(place.probe_mm, {}, tree.nearest(place.probe_mm));
      // Beside an edge the nearest surface may be the next face's: that pushes out sideways, not through.
      through += !touch.touching || dot(touch.force_N, place.normal) < 0.0 ? 1 : 0;
      if (!reference[i].touching || dot(reference[i].force_N, place.normal) < 0.0) continue;
      sum += std::min(1.0, length(touch.force_N - reference[i].force_N) / length(reference[i].force_N));
      ++judged;
    }
    trial.mean_error = (judged == 0 ? 0.0 : sum / static_cast<double>(judged)) + fit;
    trial.pushes_through = static_cast<double>(through) / static_cast<double>(std::max<std::size_t>(1, places.size()));
  }
  const auto holds = [](const ModelTrial& t) { return t.pushes_through <= kThroughLimit; };
  const auto good = [&](const ModelTrial& t) { return holds(t) && t.mean_error <= accuracy; };
  const auto found = std::find_if(out.trials.begin(), out.trials.end(), good);
  out.met = found != out.trials.end();
  out.chosen =
      (out.met ? found
               : std::min_element(out.trials.begin(), out.trials.end(),
                                  [&](const ModelTrial& a, const ModelTrial& b) {
                                    return std::pair(!holds(a), a.mean_error) < std::pair(!holds(b), b.mean_error);
                                  }))
          ->model;
  return out;
}

}  // namespace fyd::scene
