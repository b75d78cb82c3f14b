#include "core/scene/scene_bytes.h"

#include <bit>
#include <cstring>
#include <map>

#include <nlohmann/json.hpp>

namespace fyd::scene {
namespace {

using nlohmann::json;

constexpr int kFormat = 1;
constexpr std::size_t kVertex_bytes = 3 * sizeof(double), kTriangle_bytes = 3 * sizeof(std::uint32_t);
static_assert(std::endian::native == std::endian::little && sizeof(Vec3) == kVertex_bytes &&
              sizeof(Triangle) == kTriangle_bytes);

template <class Item>
json bytesOf(std::span<const Item> items) {
  const auto* from = reinterpret_cast<const std::uint8_t*>(items.data());
  return json::binary({from, from + items.size_bytes()});
}

template <class Item>
std::vector<Item> itemsOf(const json& from, const char* what) {
  const auto& bytes = from.get_binary();
  if (bytes.size() % sizeof(Item) != 0) {
    throw std::length_error(fmt::format("{} of {} bytes; expected a multiple of {}", what, bytes.size(), sizeof(Item)));
  }
  std::vector<Item> items(bytes.size() / sizeof(Item));
  if (!items.empty()) std::memcpy(items.data(), bytes.data(), bytes.size());
  return items;
}

Result<FeltScene> unpack(const json& from) {
  if (const int format = from.at("format").get<int>(); format != kFormat) {
    return fail("a scene of format {}; this program reads format {}", format, kFormat);
  }
  auto loaded = std::make_shared<LoadedScene>();
  loaded->text = from.at("text").get<std::string>();
  auto description = parseScene(loaded->text, "the scene's text");
  if (!description) return tl::unexpected(description.error());
  loaded->description = std::move(*description);
  loaded->description.settings.name = from.at("name").get<std::string>();
  const json& bodies = from.at("bodies");
  if (bodies.size() != loaded->description.bodies.size()) {
    return fail("a scene of {} bodies with the contacts of {}", loaded->description.bodies.size(), bodies.size());
  }
  std::vector<std::shared_ptr<const SearchedMesh>> meshes(from.at("meshes").size());
  std::vector<BodyModel> models;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const json& body = bodies.at(i);
    const auto which = body.at("mesh").get<std::size_t>();
    const json& stored = from.at("meshes").at(which);
    if (!meshes[which]) {
      auto mesh = Mesh::build({.vertices = itemsOf<Vec3>(stored.at("vertices_mm"), "vertices_mm"),
                               .triangles = itemsOf<Triangle>(stored.at("triangles"), "triangles")});
      if (!mesh) return tl::unexpected(mesh.error());
      const bool walks = needsWalkableMesh(
          loaded->description, [&](std::size_t k) { return bodies.at(k).at("mesh").get<std::size_t>() == which; });
      meshes[which] = std::make_shared<const SearchedMesh>(std::move(*mesh), walks);
    }
    loaded->meshes.push_back(meshes[which]);
    auto& texture = loaded->textures.emplace_back();
    if (const auto text = body.at("texture").get<std::string>(); !text.empty()) {
      auto model = texture::parseSurface(text, "the scene's stored surface");
      if (!model) return tl::unexpected(model.error());
      texture = std::move(*model);
    }
    const auto name = body.at("contact").get<std::string>();
    const auto* const known = std::ranges::find(kContactModels, name);
    if (known == kContactModels.end()) return fail("contact '{}': this program does not know it", name);
    models.push_back({.contact = static_cast<ContactModel>(known - kContactModels.begin()),
                      .resolution = {.most_points = body.at("most_points").get<std::size_t>()}});
  }
  return FeltScene::build(std::move(loaded), std::move(models), from.at("rate_Hz").get<double>());
}

}  // namespace

std::string packScene(const FeltScene& scene) {
  const LoadedScene& loaded = *scene.loaded();
  json out{{"format", kFormat},       {"name", loaded.description.settings.name},
           {"text", loaded.text},     {"rate_Hz", scene.rate_Hz()},
           {"meshes", json::array()}, {"bodies", json::array()}};
  std::map<const SearchedMesh*, std::size_t> places;
  for (std::size_t i = 0; i < loaded.meshes.size(); ++i) {
    const SearchedMesh& mesh = *loaded.meshes[i];
    const auto [place, first] = places.emplace(&mesh, places.size());
    if (first) {
      out["meshes"].push_back(
          {{"vertices_mm", bytesOf(mesh.mesh.vertices())}, {"triangles", bytesOf(mesh.mesh.triangles())}});
    }
    const BodyModel& model = scene.models()[i];
    const auto& texture = loaded.textures[i];
    out["bodies"].push_back({{"mesh", place->second},
                             {"texture", texture ? formatSurface(*texture) : std::string{}},
                             {"contact", kContactModels[static_cast<std::size_t>(model.contact)]},
                             {"most_points", model.resolution.most_points}});
  }
  std::string bytes;
  json::to_cbor(out, bytes);
  return bytes;
}

Result<FeltScene> unpackScene(std::string_view bytes) {
  try {
    return unpack(json::from_cbor(bytes.begin(), bytes.end()));
  } catch (const std::exception& problem) {
    return fail("{} bytes are not a scene: {}", bytes.size(), verbatim(problem.what()));
  }
}

}  // namespace fyd::scene
