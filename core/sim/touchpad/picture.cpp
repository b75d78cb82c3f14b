#include "core/sim/touchpad/picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fyd::sim {
namespace {

constexpr double kClothGrey = 245.0;
constexpr double kFingerGrey = 60.0;
constexpr double kDarkFrom_N = 0.1;
constexpr double kHalfDiagonal_px = 200.0;
constexpr double kScale = 16.0;  // of the stored greys: sixteenths
constexpr std::size_t kNoiseSize = 1U << 16U;

std::int16_t sixteenths(double grey) {
  return static_cast<std::int16_t>(std::lround(std::clamp(grey * kScale, -16000.0, 16000.0)));
}

std::uint8_t toGrey(int sixteenths_of_grey) {
  return static_cast<std::uint8_t>(std::clamp((sixteenths_of_grey + 8) >> 4, 0, 255));
}

}  // namespace

PicturePoint pictureOf(double x_mm, double y_mm) { return {150.0 + x_mm / kMmPerPx_u, 120.0 - y_mm / kMmPerPx_v}; }

Spot seenFromBelow(const Spot& spot, double depth_mm, double height_mm) {
  const double nearer = height_mm / (height_mm - depth_mm);
  return {nearer * spot.x_mm, nearer * spot.y_mm, nearer * nearer * spot.area_mm2};
}

Spot seenSpot(const WorldSnapshot& world, const SimParameters& parameters) {
  const FingerState& finger = world.finger;
  if (finger.lifted) return {finger.x_mm, finger.y_mm, 0.0};
  if (parameters.cloth == ClothKind::ideal) {
    return {finger.x_mm, finger.y_mm, std::numbers::pi * std::pow(spotRadius_mm(world.force_N), 2)};
  }
  return seenFromBelow({world.contact_x_mm, world.contact_y_mm, world.contact_area_mm2}, finger.indentation_mm,
                       parameters.cloth_height_mm);
}

PictureRenderer::PictureRenderer(const SimParameters& parameters)
    : parameters_(parameters),
      edge_softness_mm_(parameters.edge_softness_px * kMmPerPx_u),
      finger_(sixteenths(kFingerGrey * parameters.light)) {
  cloth_.reserve(static_cast<std::size_t>(kPictureWidth_px) * kPictureHeight_px);
  for (int v = 0; v < kPictureHeight_px; ++v) {
    for (int u = 0; u < kPictureWidth_px; ++u) {
      const double r = std::hypot(u - kPictureWidth_px / 2, v - kPictureHeight_px / 2) / kHalfDiagonal_px;
      const double gradient = 1.0 + parameters.light_gradient * (u / (kPictureWidth_px - 1.0) - 0.5);
      cloth_.push_back(
          sixteenths(kClothGrey * parameters.light * gradient * (1.0 - parameters.camera_vignette * r * r)));
    }
  }
  std::mt19937_64 random(static_cast<std::uint64_t>(parameters.seed));
  std::normal_distribution<double> normal;
  noise_.reserve(kNoiseSize + kPictureWidth_px);
  for (std::size_t i = 0; i < kNoiseSize + kPictureWidth_px; ++i) {
    noise_.push_back(sixteenths(parameters.camera_noise * normal(random)));
  }
}

void PictureRenderer::render(const WorldSnapshot& world, std::mt19937_64& random, cv::Mat& picture) const {
  picture.create(kPictureHeight_px, kPictureWidth_px, CV_8UC1);
  const auto [x_mm, y_mm, area_mm2] = seenSpot(world, parameters_);
  const double radius_mm = std::sqrt(area_mm2 / std::numbers::pi);
  const double darkness = std::clamp(world.force_N / kDarkFrom_N, 0.0, 1.0);
  const double reach_mm = radius_mm + edge_softness_mm_;
  const PicturePoint top_left = pictureOf(x_mm - reach_mm, y_mm + reach_mm);
  const PicturePoint bottom_right = pictureOf(x_mm + reach_mm, y_mm - reach_mm);
  const int u_first = std::clamp(static_cast<int>(std::floor(top_left.u_px)), 0, kPictureWidth_px);
  const int u_end = std::clamp(static_cast<int>(std::ceil(bottom_right.u_px)) + 1, u_first, kPictureWidth_px);

  for (int v = 0; v < kPictureHeight_px; ++v) {
    const std::int16_t* cloth = cloth_.data() + static_cast<std::ptrdiff_t>(v) * kPictureWidth_px;
    const std::int16_t* noise = noise_.data() + (random() & (kNoiseSize - 1));
    std::uint8_t* out = picture.ptr<std::uint8_t>(v);
    for (int u = 0; u < kPictureWidth_px; ++u) out[u] = toGrey(cloth[u] + noise[u]);
    if (radius_mm <= 0.0 || v < top_left.v_px || v > bottom_right.v_px) continue;
    const double dy_mm = (120.0 - v) * kMmPerPx_v - y_mm;
    for (int u = u_first; u < u_end; ++u) {
      const double dx_mm = (u - 150.0) * kMmPerPx_u - x_mm;
      const double outside = (std::hypot(dx_mm, dy_mm) - radius_mm) / edge_softness_mm_;  // −1…1 across the edge
      const double t = std::clamp(0.5 - 0.5 * outside, 0.0, 1.0);
      const double share = darkness * t * t * (3.0 - 2.0 * t);
      out[u] = toGrey(cloth[u] + static_cast<int>(share * (finger_ - cloth[u])) + noise[u]);
    }
  }
}

}  // namespace fyd::sim
