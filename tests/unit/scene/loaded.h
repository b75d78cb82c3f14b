// Builds scenes for tests without files.
#pragma once

#include <stdexcept>

#include "core/scene/felt_scene.h"
#include "tests/unit/scene/shapes.h"

namespace fyd::scene {

/// @param soups of the bodies, in their order
inline std::shared_ptr<const LoadedScene> loaded(const std::string& text, std::vector<TriangleSoup> soups,
                                                 const std::optional<texture::SurfaceModel>& texture = {}) {
  auto description = parseScene(text, "scene.toml");
  if (!description) throw std::runtime_error(description.error().message.text());
  auto out = std::make_shared<LoadedScene>();
  out->text = text;
  out->description = std::move(*description);
  for (TriangleSoup& soup : soups) {
    out->meshes.push_back(std::make_shared<const SearchedMesh>(shapes::built(std::move(soup))));
    out->textures.push_back(texture);
  }
  return out;
}

inline FeltScene felt(std::shared_ptr<const LoadedScene> from) {
  auto scene = FeltScene::build(std::move(from), 1000.0);
  if (!scene) throw std::runtime_error(scene.error().message.text());
  return std::move(*scene);
}

inline texture::SurfaceModel ribbed() {
  texture::SurfaceModel model;
  model.name = "ribbed";
  model.bands = {{.wavelength_mm = 0.4, .quality = 3.0, .rms_g = 0.3}};
  return model;
}

}  // namespace fyd::scene
