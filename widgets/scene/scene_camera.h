// The camera of a scene: parallel projection, so that a length in pixels does not depend on depth and a drag in the
// picture is a motion in millimetres. z points up.
#pragma once

#include <QPointF>
#include <QSizeF>
#include <algorithm>
#include <array>
#include <limits>

#include "core/scene/mesh/vector.h"

namespace fyd::widgets {

/// The smallest box around what was added, its sides along the axes.
struct SceneBox {
  static constexpr double kRadiusOfNothing_mm = 50.0;
  Vec3 lowest_mm{kFar, kFar, kFar}, highest_mm{-kFar, -kFar, -kFar};

  void add(Vec3 place_mm) {  ///< ignores NaN and infinite values
    if (!place_mm.finite()) return;
    lowest_mm = {std::min(lowest_mm.x, place_mm.x), std::min(lowest_mm.y, place_mm.y),
                 std::min(lowest_mm.z, place_mm.z)};
    highest_mm = {std::max(highest_mm.x, place_mm.x), std::max(highest_mm.y, place_mm.y),
                  std::max(highest_mm.z, place_mm.z)};
  }
  void add(const SceneBox& other) {
    if (!other.empty()) add(other.lowest_mm), add(other.highest_mm);
  }
  [[nodiscard]] bool empty() const { return !(lowest_mm.x <= highest_mm.x); }
  [[nodiscard]] Vec3 middle() const { return empty() ? Vec3{} : 0.5 * lowest_mm + 0.5 * highest_mm; }
  /// Of the sphere around it. A single point's, and that of nothing, is kRadiusOfNothing_mm.
  [[nodiscard]] double radius() const {
    const double half = empty() ? 0.0 : (0.5 * highest_mm - 0.5 * lowest_mm).norm();
    return half > 0.0 && std::isfinite(half) ? half : kRadiusOfNothing_mm;
  }
  [[nodiscard]] std::array<Vec3, 8> corners() const {
    std::array<Vec3, 8> out;
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = {((i & 1U) != 0 ? highest_mm : lowest_mm).x, ((i & 2U) != 0 ? highest_mm : lowest_mm).y,
                ((i & 4U) != 0 ? highest_mm : lowest_mm).z};
    }
    return out;
  }

  static constexpr double kFar = std::numeric_limits<double>::infinity();
};

enum class SceneSide { home, front, top, right };

class SceneCamera {
 public:
  static constexpr double kLeastZoom = 1e-3;  ///< of the picture that shows everything
  static constexpr double kMostZoom = 1e4;

  /// Turns to one of the standard views and shows the whole box; an empty one as a cube around the origin.
  void look(SceneSide side, const SceneBox& box, QSizeF picture_px);
  void orbit(double azimuth_deg, double elevation_deg);  ///< by so much; beyond the poles it stops
  void pan(QPointF by_px);                               ///< the scene follows the mouse
  /// @param factor above 1 comes nearer; what lies under `at_px` stays there
  void zoom(double factor, QPointF at_px, QSizeF picture_px);

  [[nodiscard]] double azimuth_deg() const { return azimuth_deg_; }
  [[nodiscard]] double elevation_deg() const { return elevation_deg_; }
  [[nodiscard]] double mmPerPixel() const { return mm_per_px_; }  ///< of the widget's own pixels
  [[nodiscard]] Vec3 target_mm() const { return target_mm_; }
  [[nodiscard]] Vec3 right() const;
  [[nodiscard]] Vec3 up() const;
  [[nodiscard]] Vec3 forward() const;                            ///< away from the eye
  [[nodiscard]] Vec3 centre_mm() const { return centre_mm_; }    ///< of the box it looked at
  [[nodiscard]] double radius_mm() const { return radius_mm_; }  ///< of the sphere around that box

  /// Where a place is drawn in a picture of this size. NaN in, NaN out.
  [[nodiscard]] QPointF project(Vec3 place_mm, QSizeF picture_px) const;
  /// Distance behind the plane through the target; smaller is nearer to the eye.
  [[nodiscard]] double depth_mm(Vec3 place_mm) const;
  /// A motion in the plane of the picture.
  [[nodiscard]] Vec3 motion(QPointF by_px) const;

  friend bool operator==(const SceneCamera&, const SceneCamera&) = default;

 private:
  double azimuth_deg_ = 0.0;
  double elevation_deg_ = 0.0;
  double mm_per_px_ = 0.25;
  Vec3 target_mm_;
  Vec3 centre_mm_;
  double radius_mm_ = SceneBox::kRadiusOfNothing_mm;
  double whole_mm_per_px_ = 0.25;
};

}  // namespace fyd::widgets
