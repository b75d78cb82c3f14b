#include <charconv>
#include <cmath>

#include "core/base/toml_parameters.h"
#include "core/scene/mesh/vector.h"
#include "core/scene/scene_description.h"

namespace fyd::scene {
namespace {

constexpr std::string_view kListedBy = "fyd scene keys";
constexpr std::size_t kMostBodies = 1000;
constexpr std::string_view kTables = "[scene], [[body]], [swords], [fencing], [ball], [serve], [palpation] and [plane]";

template <class Parameters>
Result<void> readInto(Parameters& to, const toml::node& node, std::string_view room, std::string_view source_name) {
  const toml::table* table = node.as_table();
  if (table == nullptr) return fail("{}: '{}': expected a table [{}]", place(source_name, node), room, room);
  const std::vector<Parameter> parameters = bindParameters(to);
  std::vector<TomlAssignment> read;
  if (auto done = readTable(*table, room, source_name, parameters, Ranges::bind, kListedBy, read); !done) return done;
  for (const TomlAssignment& assignment : read) assignment.store();
  return {};
}

Result<void> checkBody(const BodyDescription& body, const std::string& where) {
  if (body.mesh.empty()) return fail("{}: body.mesh: expected an OBJ, STL or PLY file", where);
  const auto three = [](const ParameterList& list) { return list.size() == 0 || list.size() == 3; };
  if (!three(body.position_mm)) return fail("{}: body.position_mm: expected three numbers", where);
  if (!three(body.turned_deg)) return fail("{}: body.turned_deg: expected three numbers", where);
  if (!three(body.velocity_mm_per_s)) return fail("{}: body.velocity_mm_per_s: expected three numbers", where);
  if (body.soft && body.contact != ContactChoice::automatic) {
    return fail("{}: body.contact: a soft body has its own; expected none beside body.soft", where);
  }
  if (body.kinetic_friction > body.static_friction) {
    return fail("{}: body.kinetic_friction {}: expected at most body.static_friction, {}", where, body.kinetic_friction,
                body.static_friction);
  }
  return {};
}

/// "1%" or "0.01". @return nothing when it is none of them
std::optional<double> shareOf(std::string_view text) {
  const bool percent = text.ends_with('%');
  if (percent) text.remove_suffix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  double value = 0.0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  value *= percent ? 0.01 : 1.0;
  return value > 0.0 && value <= 1.0 ? std::optional(value) : std::nullopt;
}

Result<void> readBodies(SceneDescription& scene, const toml::node& node, std::string_view source_name) {
  const toml::array* array = node.as_array();
  if (array == nullptr) return fail("{}: 'body': expected tables [[body]]", place(source_name, node));
  if (array->size() > kMostBodies) {
    return fail("{}: {} bodies; at most {}", place(source_name, node), array->size(), kMostBodies);
  }
  for (const toml::node& item : *array) {
    BodyDescription& body = scene.bodies.emplace_back();
    if (auto read = readInto(body, item, "body", source_name); !read) return read;
    if (auto good = checkBody(body, place(source_name, item)); !good) return good;
    if (body.name.empty()) body.name = body.mesh.substr(body.mesh.rfind('/') + 1);
  }
  return {};
}

}  // namespace

Result<SceneDescription> parseScene(std::string_view text, std::string_view source_name) {
  const auto root = parseToml(text, source_name);
  if (!root) return tl::unexpected(root.error());
  SceneDescription scene;
  for (const auto& [key, node] : *root) {
    const std::string_view room = key.str();
    // Named anew: clang 14 captures no structured binding.
    const auto into = [&, &described = node](auto& parameters) {
      return readInto(parameters, described, room, source_name);
    };
    const Result<void> read = room == "scene"       ? into(scene.settings)
                              : room == "body"      ? readBodies(scene, node, source_name)
                              : room == "swords"    ? into(scene.swords.emplace())
                              : room == "fencing"   ? into(scene.fencing)
                              : room == "ball"      ? into(scene.ball.emplace())
                              : room == "serve"     ? into(scene.serve)
                              : room == "palpation" ? into(scene.palpation.emplace())
                              : room == "plane"
                                  ? into(scene.plane)
                                  : fail("{}: '{}': expected one of {}", place(source_name, node), room, kTables);
    if (!read) return tl::unexpected(read.error());
  }
  if (!scene.settings.accuracy.empty()) {
    scene.accuracy = shareOf(scene.settings.accuracy);
    if (!scene.accuracy) {
      return fail("{}: scene.accuracy \"{}\": expected a share such as \"1%\", above 0 and up to 100%", source_name,
                  scene.settings.accuracy);
    }
  }
  const auto alone = [&](std::string_view second, bool first, std::string_view of) -> Result<void> {
    if (first || !root->contains(second)) return {};
    return fail("{}: [{}] without [{}]", source_name, second, of);
  };
  if (auto good = alone("fencing", scene.swords.has_value(), "swords"); !good) return tl::unexpected(good.error());
  if (auto good = alone("serve", scene.ball.has_value(), "ball"); !good) return tl::unexpected(good.error());
  if (auto good = alone("plane", scene.palpation.has_value(), "palpation"); !good) return tl::unexpected(good.error());
  if (scene.palpation && squared({scene.plane.normal_x, scene.plane.normal_y, scene.plane.normal_z}) == 0.0) {
    return fail("{}: plane.normal_x, normal_y and normal_z are 0: expected a direction", source_name);
  }
  if (scene.bodies.empty() && !scene.swords && !scene.ball && !scene.palpation) {
    return fail("{}: nothing to touch; expected a [[body]], [swords], [ball] or [palpation]", source_name);
  }
  return scene;
}

}  // namespace fyd::scene
