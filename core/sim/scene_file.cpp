#include "core/sim/scene_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/base/system_reason.h"

namespace fyd::sim {
namespace {

constexpr std::uintmax_t kLargestMesh_bytes = 4ULL << 30;

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

}  // namespace fyd::sim
