#include "core/sim/scene_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <utility>

#include "core/base/system_reason.h"

namespace fyd::sim {
namespace {

constexpr std::uintmax_t kLargestMesh_bytes = 4ULL << 30;
constexpr std::uintmax_t kLargestScene_bytes = 1 << 20;

Result<std::string> readFile(const std::string& path, std::uintmax_t largest_bytes) {
  std::error_code problem;
  const auto kind = std::filesystem::status(path, problem).type();
  if (problem) return fail("{}: cannot be read: {}", path, systemReason(problem));
  if (kind != std::filesystem::file_type::regular) return fail("{}: no regular file", path);
  const std::uintmax_t size = std::filesystem::file_size(path, problem);
  if (problem) return fail("{}: cannot be read: {}", path, systemReason(problem));
  if (size > largest_bytes) return fail("{}: {} bytes; expected at most {}", path, size, largest_bytes);
  std::ifstream file(path, std::ios::binary);
  std::string bytes(size, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  if (!file) return fail("{}: cannot be read", path);
  return bytes;
}

}  // namespace

Result<scene::Mesh> openMesh(const std::string& path, scene::LengthUnit unit) {
  const auto format = scene::meshFormatOf(path);
  if (!format) return tl::unexpected(format.error());
  auto soup = [&]() -> Result<scene::TriangleSoup> {
    const auto bytes = readFile(path, kLargestMesh_bytes);
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

Result<SceneFile> openScene(const std::string& path) {
  const auto text = readFile(path, kLargestScene_bytes);
  if (!text) return tl::unexpected(text.error());
  auto description = scene::parseScene(*text, path);
  if (!description) return tl::unexpected(description.error());
  SceneFile out{.description = std::move(*description), .meshes = {}, .textures = {}};
  std::string& name = out.description.settings.name;
  if (name.empty()) name = std::filesystem::path(path).filename().string();
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::map<std::pair<std::string, scene::LengthUnit>, std::shared_ptr<const scene::SearchedMesh>> known;
  const auto walks = [&](const scene::BodyDescription& of) {
    return std::ranges::any_of(out.description.bodies, [&of](const scene::BodyDescription& body) {
      return !body.soft && body.mesh == of.mesh && body.unit == of.unit;
    });
  };
  for (const scene::BodyDescription& body : out.description.bodies) {
    const std::string file = (folder / body.mesh).string();
    auto& mesh = known[{file, body.unit}];
    if (!mesh) {
      auto read = openMesh(file, body.unit);
      if (!read) return fail(about(path, read.error().message));
      mesh = std::make_shared<const scene::SearchedMesh>(std::move(*read), walks(body));
    }
    out.meshes.push_back(mesh);
    auto& texture = out.textures.emplace_back();
    if (body.texture.empty()) continue;
    const std::string stored = (folder / body.texture).string();
    const auto surface = readFile(stored, kLargestScene_bytes);
    if (!surface) return fail(about(path, surface.error().message));
    auto model = texture::parseSurface(*surface, stored);
    if (!model) return tl::unexpected(model.error());
    texture = std::move(*model);
  }
  return out;
}

Result<std::vector<BodyChoice>> chooseModels(const SceneFile& file) {
  using scene::ContactChoice;
  std::vector<BodyChoice> out;
  for (std::size_t i = 0; i < file.meshes.size(); ++i) {
    const scene::BodyDescription& body = file.description.bodies[i];
    const scene::TriangleTree& tree = file.meshes[i]->tree;
    BodyChoice& to = out.emplace_back();
    if (!body.soft && body.contact != ContactChoice::automatic) {  // stands before the models
      to.model.contact = static_cast<scene::ContactModel>(static_cast<int>(body.contact) - 1);
    } else if (file.description.accuracy && body.soft) {
      auto chosen = scene::chooseSoft(tree, scene::materialOf(body), *file.description.accuracy);
      if (!chosen) return fail(about(body.name, chosen.error().message));
      to.model.resolution = chosen->chosen;
      to.soft = std::move(*chosen);
    } else if (file.description.accuracy) {
      to.contact = chooseContact(tree, {.stiffness_N_per_mm = body.stiffness_N_per_mm},
                                 {.radius_mm = body.radius_mm, .reach_mm = body.depth_mm}, *file.description.accuracy);
      to.model.contact = to.contact->chosen;
    }
  }
  return out;
}

Result<scene::Scene> buildScene(const SceneFile& file, const std::vector<BodyChoice>& choices) {
  std::vector<scene::BodyModel> models;
  for (const BodyChoice& each : choices) models.push_back(each.model);
  return scene::Scene::build(file.description, file.meshes, models);
}

}  // namespace fyd::sim
