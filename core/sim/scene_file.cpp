#include "core/sim/scene_file.h"

#include <filesystem>
#include <map>
#include <utility>

#include "core/base/system_reason.h"
#include "core/base/whole_file.h"
#include "core/sim/resources.h"

namespace fyd::sim {
namespace {

constexpr std::uintmax_t kLargestMesh_bytes = 4ULL << 30;
constexpr std::uintmax_t kLargestScene_bytes = 1 << 20;

}  // namespace

Result<scene::Mesh> openMesh(const std::string& path, scene::LengthUnit unit) {
  const auto format = scene::meshFormatOf(path);
  if (!format) return tl::unexpected(format.error());
  auto soup = [&]() -> Result<scene::TriangleSoup> {
    const auto bytes = readWholeFile(path, kLargestMesh_bytes);
    if (!bytes) return tl::unexpected(bytes.error());
    auto parsed = scene::parseMesh(*bytes, *format, unit);
    if (!parsed) return fail(about(path, parsed.error().message));
    return parsed;
  }();
  if (!soup) return tl::unexpected(soup.error());
  auto mesh = scene::Mesh::build(std::move(*soup));
  if (!mesh) return fail(about(path, mesh.error().message));
  return mesh;
}

Result<scene::LoadedScene> openScene(const std::string& given) {
  const std::string path = findResource(given, "scenes");
  const auto text = readWholeFile(path, kLargestScene_bytes);
  if (!text) return tl::unexpected(text.error());
  auto description = scene::parseScene(*text, path);
  if (!description) return tl::unexpected(description.error());
  scene::LoadedScene out{.text = *text, .description = std::move(*description), .meshes = {}, .textures = {}};
  std::string& name = out.description.settings.name;
  if (name.empty()) name = std::filesystem::path(path).filename().string();
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::map<std::pair<std::string, scene::LengthUnit>, std::shared_ptr<const scene::SearchedMesh>> known;
  const auto meshOf = [&folder](const scene::BodyDescription& body) {
    return std::pair((folder / body.mesh).string(), body.unit);
  };
  for (const scene::BodyDescription& body : out.description.bodies) {
    const auto file = meshOf(body);
    auto& mesh = known[file];
    if (!mesh) {
      auto read = openMesh(file.first, file.second);
      if (!read) return fail(about(path, read.error().message));
      const bool walks =
          needsWalkableMesh(out.description, [&](std::size_t i) { return meshOf(out.description.bodies[i]) == file; });
      mesh = std::make_shared<const scene::SearchedMesh>(std::move(*read), walks);
    }
    out.meshes.push_back(mesh);
    auto& texture = out.textures.emplace_back();
    if (body.texture.empty()) continue;
    const std::string stored = (folder / body.texture).string();
    const auto surface = readWholeFile(stored, kLargestScene_bytes);
    if (!surface) return fail(about(path, surface.error().message));
    auto model = texture::parseSurface(*surface, stored);
    if (!model) return tl::unexpected(model.error());
    texture = std::move(*model);
  }
  return out;
}

Result<scene::FeltScene> openFeltScene(const std::string& path, double rate_Hz) {
  auto loaded = openScene(path);
  if (!loaded) return tl::unexpected(loaded.error());
  auto scene = scene::FeltScene::build(std::make_shared<const scene::LoadedScene>(std::move(*loaded)), rate_Hz);
  if (!scene) return fail(about(path, scene.error().message));
  return scene;
}

}  // namespace fyd::sim
