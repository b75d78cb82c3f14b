#include "core/scene/scene_digest.h"

#include <array>
#include <bit>
#include <span>

#include <sodium/crypto_generichash.h>

#include "core/base/parameter.h"

namespace fyd::scene {
namespace {

static_assert(std::endian::native == std::endian::little, "bytes of numbers are hashed as they lie");

constexpr std::array<std::string_view, 4> kForPeople = {"scene.name", "body.name", "body.mesh", "body.texture"};

class Hash {
 public:
  Hash() { crypto_generichash_init(&state_, nullptr, 0, kBytes); }

  void add(std::string_view text) {
    const std::uint64_t size = text.size();
    update(&size, sizeof size);
    update(text.data(), text.size());
  }
  template <class Item>
  void add(std::span<const Item> items) {
    add(std::string_view(reinterpret_cast<const char*>(items.data()), items.size_bytes()));
  }
  template <class Parameters>
  void addValues(Parameters parameters) {
    for (const Parameter& each : bindParameters(parameters)) {
      if (std::ranges::find(kForPeople, each.id) != kForPeople.end()) continue;
      add(std::string_view(each.id));
      add(formatParameter(each));
    }
  }

  std::string hexadecimal() {
    std::array<unsigned char, kBytes> bytes{};
    crypto_generichash_final(&state_, bytes.data(), bytes.size());
    std::string text;
    for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
    return text;
  }

 private:
  void update(const void* bytes, std::size_t size) {
    crypto_generichash_update(&state_, static_cast<const unsigned char*>(bytes), size);
  }

  static constexpr std::size_t kBytes = crypto_generichash_BYTES_MIN;
  crypto_generichash_state state_{};
};

}  // namespace

std::string digestOf(const LoadedScene& scene, SurfaceNames names) {
  const SceneDescription& d = scene.description;
  Hash hash;
  hash.addValues(d.settings);
  if (d.swords) {
    hash.addValues(*d.swords);
    hash.addValues(d.fencing);
  }
  if (d.ball) {
    hash.addValues(*d.ball);
    hash.addValues(d.serve);
  }
  if (d.palpation) {
    hash.addValues(*d.palpation);
    hash.addValues(d.plane);
  }
  for (std::size_t i = 0; i < d.bodies.size(); ++i) {
    hash.addValues(d.bodies[i]);
    hash.add(scene.meshes[i]->mesh.vertices());
    hash.add(scene.meshes[i]->mesh.triangles());
    std::optional<texture::SurfaceModel> surface = scene.textures[i];
    if (surface && names == SurfaceNames::left_out) surface->name = surface->description = {};
    hash.add(surface ? formatSurface(*surface) : std::string{});
  }
  return hash.hexadecimal();
}

}  // namespace fyd::scene
