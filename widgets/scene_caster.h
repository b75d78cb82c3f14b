// The picture of a scene's bodies and moving parts, cast ray by ray with Embree on the thread that calls: colour, and
// depth for what is drawn over it. A picture is kept; only the tiles in which something moved are cast again.
//
// No graphics card, no window system, no thread of its own.
#pragma once

#include <QColor>
#include <QImage>
#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "widgets/scene_camera.h"
#include "widgets/scene_parts.h"

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
  Vec3 middle_mm;  ///< of all where they were given
  double radius_mm = SceneBox::kRadiusOfNothing_mm;
  std::size_t triangles = 0;     ///< that are drawn
  std::size_t left_out = 0;      ///< no number, or no such vertex
  std::vector<QString> too_big;  ///< names of the bodies that are not drawn: more than scene::kMostTriangles in all

  [[nodiscard]] static std::shared_ptr<const SceneMeshes> of(std::span<const SceneBody> bodies);
  /// @return x, y, z of the vertices as floats; empty when there is not one for each of the body's
  [[nodiscard]] std::vector<float> shapeOf(std::size_t body, std::span<const Vec3> vertices_mm) const;
  [[nodiscard]] Vec3 unitOf(Vec3 place_mm) const { return (1.0 / radius_mm) * (place_mm - middle_mm); }
};

/// A body's shape where it is not the one that was given; null: as given.
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

struct ScenePicture {
  SceneShot shot;
  QImage image;                 ///< RGB32
  std::vector<float> depth_mm;  ///< of each pixel as SceneCamera::depth_mm; infinity: nothing there
  SceneFineness fineness;       ///< of what was cast last
  double took_ms = 0.0;         ///< of a processor
  std::size_t rays = 0;         ///< cast for it
  [[nodiscard]] double depthAt(QPointF device_px) const;
};

class SceneCaster {
 public:
  SceneCaster();
  ~SceneCaster();
  SceneCaster(const SceneCaster&) = delete;
  SceneCaster& operator=(const SceneCaster&) = delete;

  /// Builds Embree's trees. @param go_on asked meanwhile: false gives up
  /// @return false when given up, or without memory: then problem() says why and nothing is drawn
  bool build(std::shared_ptr<const SceneMeshes> meshes, const std::function<bool()>& go_on);
  [[nodiscard]] const std::shared_ptr<const SceneMeshes>& meshes() const { return meshes_; }
  /// Embree's words; empty while all is well.
  [[nodiscard]] const QString& problem() const { return problem_; }

  /// Where everything stands from now on. The tiles of `picture()` that this touches are cast anew.
  void move(const SceneParts& parts, const std::vector<SceneShape>& shapes, const SceneShot& shot);
  /// Pixels of the picture that cast() would cast anew for this.
  [[nodiscard]] std::size_t pixelsToCast(const SceneShot& shot, SceneFineness fineness) const;
  /// @param go_on asked after each row of tiles. @return false when given up: picture() is then part old, part new
  bool cast(const SceneShot& shot, SceneFineness fineness, const std::function<bool()>& go_on);
  [[nodiscard]] const ScenePicture& picture() const { return picture_; }

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  std::shared_ptr<const SceneMeshes> meshes_;
  ScenePicture picture_;
  QString problem_;
};

}  // namespace fyd::widgets
