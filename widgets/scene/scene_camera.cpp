#include "widgets/scene/scene_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fyd::widgets {
namespace {

constexpr double kHomeAzimuth_deg = -30.0;
constexpr double kHomeElevation_deg = 30.0;
constexpr double kFilled = 0.8;        // share of the picture that the scene fills
constexpr double kLeastFilled = 0.25;  // least extent to fit, in radii, for a plane seen edge-on

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

}  // namespace

void SceneCamera::look(SceneSide side, const SceneBox& box, QSizeF picture_px) {
  switch (side) {
    case SceneSide::home:
      azimuth_deg_ = kHomeAzimuth_deg;
      elevation_deg_ = kHomeElevation_deg;
      break;
    case SceneSide::front: azimuth_deg_ = elevation_deg_ = 0.0; break;
    case SceneSide::top:
      azimuth_deg_ = 0.0;
      elevation_deg_ = 90.0;
      break;
    case SceneSide::right:
      azimuth_deg_ = 90.0;
      elevation_deg_ = 0.0;
      break;
  }
  target_mm_ = centre_mm_ = box.middle();
  radius_mm_ = box.radius();
  double across = kLeastFilled * radius_mm_, upward = across;  // mm from the middle
  for (const Vec3& corner : box.corners()) {
    if (box.empty()) break;
    across = std::max(across, std::abs(scene::dot(corner - centre_mm_, right())));
    upward = std::max(upward, std::abs(scene::dot(corner - centre_mm_, up())));
  }
  const double wide_px = std::max(1.0, kFilled * picture_px.width());
  const double high_px = std::max(1.0, kFilled * picture_px.height());
  whole_mm_per_px_ = mm_per_px_ = 2.0 * std::max(across / wide_px, upward / high_px);
}

void SceneCamera::orbit(double azimuth_deg, double elevation_deg) {
  if (!std::isfinite(azimuth_deg) || !std::isfinite(elevation_deg)) return;
  azimuth_deg_ = std::remainder(azimuth_deg_ + azimuth_deg, 360.0);
  elevation_deg_ = std::clamp(elevation_deg_ + elevation_deg, -90.0, 90.0);
}

void SceneCamera::pan(QPointF by_px) {
  const Vec3 moved = target_mm_ - motion(by_px);
  // Limits panning to 10 radii from the scene's middle.
  if (moved.finite() && (moved - centre_mm_).norm() <= 10.0 * radius_mm_) target_mm_ = moved;
}

void SceneCamera::zoom(double factor, QPointF at_px, QSizeF picture_px) {
  if (!std::isfinite(factor) || factor <= 0.0) return;
  const double before = mm_per_px_;
  mm_per_px_ = std::clamp(before / factor, whole_mm_per_px_ / kMostZoom, whole_mm_per_px_ / kLeastZoom);
  const QPointF from_middle = at_px - QPointF(picture_px.width() / 2, picture_px.height() / 2);
  // Pans back so that the place under the mouse stays there.
  pan(from_middle * (1.0 - before / mm_per_px_));
}

Vec3 SceneCamera::right() const {
  const double a = radians(azimuth_deg_);
  return {std::cos(a), std::sin(a), 0.0};
}

Vec3 SceneCamera::up() const {
  const double a = radians(azimuth_deg_), e = radians(elevation_deg_);
  return {-std::sin(a) * std::sin(e), std::cos(a) * std::sin(e), std::cos(e)};
}

Vec3 SceneCamera::forward() const {
  const double a = radians(azimuth_deg_), e = radians(elevation_deg_);
  return {-std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), -std::sin(e)};
}

QPointF SceneCamera::project(Vec3 place_mm, QSizeF picture_px) const {
  const Vec3 from_target = place_mm - target_mm_;
  return {picture_px.width() / 2 + scene::dot(from_target, right()) / mm_per_px_,
          picture_px.height() / 2 - scene::dot(from_target, up()) / mm_per_px_};
}

double SceneCamera::depth_mm(Vec3 place_mm) const { return scene::dot(place_mm - target_mm_, forward()); }

Vec3 SceneCamera::motion(QPointF by_px) const {
  return (mm_per_px_ * by_px.x()) * right() - (mm_per_px_ * by_px.y()) * up();
}

}  // namespace fyd::widgets
