// The picture of a scene's bodies and moving parts, cast ray by ray with Embree on the thread that calls: colour, and
// depth for what is drawn over it. A picture is kept; only the tiles in which something moved are cast again.
//
// No graphics card, no window system, no thread of its own.
#pragma once

#include <QImage>
#include <functional>
#include <memory>
#include <vector>

#include "widgets/scene/scene_shot.h"

namespace fyd::widgets {

struct ScenePicture {
  SceneShot shot;
  QImage image;                 ///< RGB32
  std::vector<float> depth_mm;  ///< of each pixel as SceneCamera::depth_mm; infinity: nothing there
  SceneFineness fineness;       ///< of what was cast last
  double took_ms = 0.0;         ///< processor time
  std::size_t rays = 0;         ///< cast for it
  [[nodiscard]] double depthAt(QPointF device_px) const;
};

class SceneCaster {
 public:
  SceneCaster();
  ~SceneCaster();
  SceneCaster(const SceneCaster&) = delete;
  SceneCaster& operator=(const SceneCaster&) = delete;

  /// Builds Embree's trees. @param go_on called meanwhile: false cancels
  /// @return false when cancelled, or out of memory: then problem() says why and nothing is drawn
  bool build(std::shared_ptr<const SceneMeshes> meshes, const std::function<bool()>& go_on);
  [[nodiscard]] const std::shared_ptr<const SceneMeshes>& meshes() const { return meshes_; }
  /// Embree's error message; empty: none.
  [[nodiscard]] const QString& problem() const { return problem_; }

  /// Sets the poses of all parts. The next cast() casts the tiles of `picture()` that this changes.
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
