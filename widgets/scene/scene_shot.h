// What one picture of a scene is made of: the bodies as they are cast, from where, in which colours, how fine.
#pragma once

#include <QColor>
#include <QSize>
#include <QString>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "widgets/scene/scene_camera.h"
#include "widgets/scene/scene_parts.h"

namespace fyd::widgets {

/// The bodies as they are cast: floats around the scene's middle in units of its radius, so that a scene of 1e-6 mm is
/// drawn as well as one of 1e6.
struct SceneMeshes {
  struct Body {
    QString name;
    SceneRole role = SceneRole::rigid;
    std::vector<float> vertices;  ///< x, y, z; one more at the end, which Embree may read
    std::vector<std::uint32_t> triangles;
    SceneBox box;  ///< of the vertices that triangles use
  };
  std::vector<Body> bodies;
  Vec3 middle_mm;  ///< of all bodies as given
  double radius_mm = SceneBox::kRadiusOfNothing_mm;
  std::size_t triangles = 0;     ///< that are drawn
  std::size_t left_out = 0;      ///< triangles with a non-finite vertex or an index out of range
  std::vector<QString> too_big;  ///< names of the bodies that are not drawn: more than scene::kMostTriangles in all

  [[nodiscard]] static std::shared_ptr<const SceneMeshes> of(std::span<const SceneBody> bodies);
  /// @return x, y, z of the vertices as floats; empty when there is not one for each of the body's
  [[nodiscard]] std::vector<float> shapeOf(std::size_t body, std::span<const Vec3> vertices_mm) const;
  [[nodiscard]] Vec3 unitOf(Vec3 place_mm) const { return (1.0 / radius_mm) * (place_mm - middle_mm); }
};

/// A body's deformed vertices; null: as given.
using SceneShape = std::shared_ptr<const std::vector<float>>;

struct SceneColours {
  QColor ground;
  std::array<QColor, kSceneRoles> outside;
  std::array<QColor, kSceneRoles> inside;  ///< hatched too
  friend bool operator==(const SceneColours&, const SceneColours&) = default;
};

struct SceneShot {
  SceneCamera camera;
  QSize size_px;             ///< of the device
  double pixel_ratio = 1.0;  ///< device pixels in one of the camera's
  SceneColours colours;
  friend bool operator==(const SceneShot&, const SceneShot&) = default;
};

/// One ray for `block` × `block` pixels, or `samples` for each pixel.
struct SceneFineness {
  int block = 1;    ///< 1, 2, 4, 8
  int samples = 1;  ///< 1 or 4
  friend bool operator==(const SceneFineness&, const SceneFineness&) = default;
};

}  // namespace fyd::widgets
