// The rays of one picture of a scene: where they begin, what they hit, and how bright it is.
#pragma once

#include <embree3/rtcore.h>

#include "widgets/scene/scene_shot.h"
#include "widgets/scene/scene_tiles.h"

namespace fyd::widgets {

struct Float3 {
  float x = 0.0F, y = 0.0F, z = 0.0F;
};
inline Float3 floats(Vec3 v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

inline constexpr float kNoDepth = std::numeric_limits<float>::infinity();  ///< of a ray that hits nothing

/// The geometries of the scene of parts, by their numbers.
enum ScenePartKind : unsigned { kSticks, kBalls, kDiscs, kSheets, kScenePartKinds };

/// Corners of its bounding box; none when it is empty.
[[nodiscard]] std::vector<Vec3> cornersOf(RTCScene scene);

struct SceneCanvas {
  QRgb* pixels;
  float* depth_mm;
  int width, height;
};

/// What the rays of one picture share.
class SceneRays {
 public:
  /// @param top of the bodies; @param parts_scene of `parts`, as they stand there
  SceneRays(RTCScene top, RTCScene parts_scene, const SceneMeshes& meshes, const std::vector<ScenePlacement>& placed,
            const SceneParts& parts, const SceneShot& shot);

  /// The tile that begins there. @param with_parts whether there are any in it
  void castTile(const SceneCanvas& canvas, SceneFineness fineness, int left, int top, bool with_parts) const;

 private:
  /// What a ray needs to know of the body it hit.
  struct Look {
    std::size_t role;
    Float3 forward, light;  ///< in the body's own frame, as the normals are
  };

  /// 4 × 4 rays, the first at pixel (x, y), `step` pixels apart.
  void packet(float x, float y, float step, bool with_parts, std::array<Float3, 16>& colour,
              std::array<float, 16>& depth_mm) const;
  [[nodiscard]] Float3 shade(const RTCHit16& hit, int i, bool hatch) const;
  [[nodiscard]] SceneRole roleOf(unsigned kind, std::size_t which) const;

  RTCScene top_;
  RTCScene parts_scene_;
  std::vector<Look> looks_;
  const SceneParts& parts_;
  double radius_mm_;
  double near_ = 0.0;
  Float3 forward_, light_, across_, down_, corner_, ground_;
  std::array<Float3, kSceneRoles> outside_, inside_;
};

}  // namespace fyd::widgets
