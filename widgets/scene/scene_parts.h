// What a view of a haptic scene shows: bodies, given once, and what moves, given again for each picture.
//
// Millimetres and newtons. Parts with NaN or infinite values are not drawn; any values are safe.
#pragma once

#include <QString>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/scene/mesh/mesh.h"

namespace fyd::widgets {

/// How a part looks. `own` is moved by this end, `other` by the far end, whose sword is also banded.
enum class SceneRole : std::uint8_t { rigid, soft, own, other };
inline constexpr std::size_t kSceneRoles = 4;

/// Views of a body's own coordinates; copied by the widget. A triangle's outside is where its vertices run
/// counter-clockwise.
struct SceneBody {
  QString name;
  std::span<const Vec3> vertices_mm;
  std::span<const scene::Triangle> triangles;
  SceneRole role = SceneRole::rigid;
};

/// Pose of a body's frame in the scene. The axes are of unit length and at right angles.
struct ScenePlacement {
  Vec3 origin_mm;
  Vec3 x_axis{1.0, 0.0, 0.0}, y_axis{0.0, 1.0, 0.0}, z_axis{0.0, 0.0, 1.0};
  friend bool operator==(const ScenePlacement&, const ScenePlacement&) = default;
};

/// A sword: a line with round ends, never thinner than three pixels.
struct SceneStick {
  Vec3 from_mm, to_mm;
  double radius_mm = 0.0;
  SceneRole role = SceneRole::own;
  friend bool operator==(const SceneStick&, const SceneStick&) = default;
};

struct SceneBall {
  Vec3 centre_mm;
  double radius_mm = 1.0;
  SceneRole role = SceneRole::rigid;
  friend bool operator==(const SceneBall&, const SceneBall&) = default;
};

/// A round racket, or a floor: flat, seen from both sides.
struct SceneDisc {
  Vec3 centre_mm;
  Vec3 normal{0.0, 0.0, 1.0};
  double radius_mm = 1.0;
  SceneRole role = SceneRole::own;
  friend bool operator==(const SceneDisc&, const SceneDisc&) = default;
};

/// A racket with corners: flat, seen from both sides.
struct SceneSheet {
  Vec3 centre_mm;
  Vec3 half_width_mm{1.0, 0.0, 0.0}, half_height_mm{0.0, 1.0, 0.0};  ///< from the centre to the middle of an edge
  SceneRole role = SceneRole::own;
  [[nodiscard]] double radius_mm() const { return scene::length(half_width_mm) + scene::length(half_height_mm); }
  friend bool operator==(const SceneSheet&, const SceneSheet&) = default;
};

inline constexpr std::size_t kMostSceneParts = 1024;  ///< of each kind; more are not drawn

inline constexpr double kSceneNone = std::numeric_limits<double>::quiet_NaN();
inline constexpr Vec3 kNowhere{kSceneNone, kSceneNone, kSceneNone};

struct SceneParts {
  std::vector<ScenePlacement> placements;  ///< of the bodies, in their order; left out: at the origin
  std::vector<SceneStick> sticks;
  std::vector<SceneBall> balls;
  std::vector<SceneDisc> discs;
  std::vector<SceneSheet> sheets;
  friend bool operator==(const SceneParts&, const SceneParts&) = default;
};

struct SceneState {
  Vec3 point_mm = kNowhere;  ///< haptic point
  Vec3 proxy_mm = kNowhere;
  Vec3 force_N = kNowhere;  ///< on the finger
  double radius_mm = 0.0;   ///< of the haptic point
  SceneParts parts;
};

}  // namespace fyd::widgets
