// Synthetic pictures of a finger on the cloth with known truth, for the detector's tests and its benchmark.
//
//   I(u, v) = L·slope(u, v)·fall-off(u, v)·(1 − (1 − ρ)·(c ∗ Gauss)(u, v)) + noise,   rounded and clipped to 0…255
//
// c is the share of each pixel that a disc covers (16 exact sub-rows). Truth is the part of the sharp disc inside the
// region of interest: its area and centroid. Deterministic from the seed and the picture's number.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "core/base/image.h"
#include "core/sensing/finger_parameters.h"

namespace fyd::bench {

struct FrameLabel {
  double area_px = 0.0;  ///< visible part, px of the camera
  double x_px = 0.0;     ///< its centroid
  double y_px = 0.0;
  double radius_px = 0.0;
  double noise = 0.0;
  double gradient = 0.0;
  double blur_px = 0.0;
  double contrast = 0.0;
  bool cut = false;  ///< partly outside the region of interest
};

struct LabelledFingers {
  double least_radius_px = 10.0;
  double most_radius_px = 32.0;
  double least_visible_px = 309.0;  ///< smallest visible area of a finger that the region's edge cuts
};

class LabelledPictures {
 public:
  static constexpr int kWidth = 320;
  static constexpr int kHeight = 240;

  explicit LabelledPictures(std::uint64_t seed = 1, const LabelledFingers& fingers = {})
      : fingers_(fingers), random_(seed) {
    std::normal_distribution<float> normal;
    noise_.resize(kNoiseSize + kWidth);
    for (float& n : noise_) n = normal(random_);
    newLight();
  }

  /// Makes the next picture: a new finger each time, new lighting every `kFramesPerLight` pictures.
  void next() {
    if (++made_ % kFramesPerLight == 0) newLight();
    do {
      newFinger();
    } while (label_.area_px < fingers_.least_visible_px);
    blurCover();
    render();
  }

  [[nodiscard]] const FrameLabel& label() const { return label_; }
  [[nodiscard]] ImageView picture() const {
    return {.data = picture_.data(), .width = kWidth, .height = kHeight, .stride = kWidth, .channels = 1};
  }

  static constexpr int kFramesPerLight = 20;

 private:
  static constexpr std::size_t kNoiseSize = 1U << 16U;
  static constexpr int kPatch = 2 * (32 + 8) + 4;

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  void newLight() {
    level_ = uniform(150.0, 240.0);
    gradient_ = uniform(0.0, 0.4);
    const double direction = uniform(-3.14159265, 3.14159265);
    slope_u_ = std::cos(direction);
    slope_v_ = std::sin(direction);
    fall_off_ = uniform(0.0, 0.15);
    // Brightest end of the region at level_, darkest at level_·(1 − gradient_).
    reach_ = std::abs(slope_u_) * 110.0 + std::abs(slope_v_) * 75.0;
  }

  [[nodiscard]] double light(double u, double v) const {
    const double along = ((u - 149.5) * slope_u_ + (v - 119.5) * slope_v_) / reach_;  // −1…1 in the region
    const double r = std::hypot(u - 159.5, v - 119.5) / 200.0;
    return level_ * (1.0 - 0.5 * gradient_ * (1.0 - along)) * (1.0 - fall_off_ * r * r);
  }

  void newFinger() {
    const sensing::FingerParameters region;
    label_ = {};
    label_.radius_px = uniform(fingers_.least_radius_px, fingers_.most_radius_px);
    label_.noise = uniform(0.0, 8.0);
    label_.blur_px = uniform(0.0, 1.0) < 0.25 ? 0.0 : uniform(0.3, 2.0);
    label_.contrast = uniform(0.45, 0.75);
    label_.gradient = gradient_;
    const double r = label_.radius_px;
    const bool may_be_cut = uniform(0.0, 1.0) < 0.3;
    const double margin = may_be_cut ? -0.5 * r : r + 1.0;
    centre_u_ = uniform(region.roi_x_px + margin, region.roi_x_px + region.roi_width_px - margin);
    centre_v_ = uniform(region.roi_y_px + margin, region.roi_y_px + region.roi_height_px - margin);
    patch_u_ = static_cast<int>(std::floor(centre_u_)) - kPatch / 2;
    patch_v_ = static_cast<int>(std::floor(centre_v_)) - kPatch / 2;
    cover();
    double sum = 0.0;
    double sum_u = 0.0;
    double sum_v = 0.0;
    double whole = 0.0;
    for (int j = 0; j < kPatch; ++j) {
      for (int i = 0; i < kPatch; ++i) {
        const double c = cover_[placeOf(i, j)];
        whole += c;
        const int u = patch_u_ + i - region.roi_x_px;
        const int v = patch_v_ + j - region.roi_y_px;
        if (u < 0 || v < 0 || u >= region.roi_width_px || v >= region.roi_height_px) continue;
        sum += c;
        sum_u += c * (patch_u_ + i);
        sum_v += c * (patch_v_ + j);
      }
    }
    label_.area_px = sum;
    label_.x_px = sum_u / sum;
    label_.y_px = sum_v / sum;
    label_.cut = sum < whole - 0.5;
  }

  static std::size_t placeOf(int i, int j) {
    return static_cast<std::size_t>(j) * kPatch + static_cast<std::size_t>(i);
  }

  /// Share of each pixel inside the disc: exact along 16 sub-rows of each row.
  void cover() {
    cover_.assign(static_cast<std::size_t>(kPatch) * kPatch, 0.0F);
    constexpr int kSubRows = 16;
    for (int j = 0; j < kPatch; ++j) {
      for (int k = 0; k < kSubRows; ++k) {
        const double v = patch_v_ + j - 0.5 + (k + 0.5) / kSubRows - centre_v_;
        const double half = std::sqrt(std::max(0.0, label_.radius_px * label_.radius_px - v * v));
        const double from = centre_u_ - half - patch_u_ + 0.5;  // pixel i covers i … i + 1
        const double to = centre_u_ + half - patch_u_ + 0.5;
        for (int i = std::max(0, static_cast<int>(from)); i < std::min(kPatch, static_cast<int>(to) + 1); ++i) {
          const double share = std::min(to, i + 1.0) - std::max(from, static_cast<double>(i));
          if (share > 0.0) cover_[placeOf(i, j)] += static_cast<float>(share / kSubRows);
        }
      }
    }
  }

  void blurCover() {
    if (label_.blur_px <= 0.0) return;
    constexpr int kReach = 7;
    float kernel[2 * kReach + 1];
    float sum = 0.0F;
    for (int k = -kReach; k <= kReach; ++k) {
      kernel[k + kReach] = static_cast<float>(std::exp(-0.5 * k * k / (label_.blur_px * label_.blur_px)));
      sum += kernel[k + kReach];
    }
    std::vector<float> half(cover_.size(), 0.0F);
    const auto pass = [&](const std::vector<float>& in, std::vector<float>& out, int step_i, int step_j) {
      for (int j = 0; j < kPatch; ++j) {
        for (int i = 0; i < kPatch; ++i) {
          float value = 0.0F;
          for (int k = -kReach; k <= kReach; ++k) {
            const int ii = i + k * step_i;
            const int jj = j + k * step_j;
            if (ii < 0 || jj < 0 || ii >= kPatch || jj >= kPatch) continue;
            value += kernel[k + kReach] * in[placeOf(ii, jj)];
          }
          out[placeOf(i, j)] = value / sum;
        }
      }
    };
    pass(cover_, half, 1, 0);
    pass(half, cover_, 0, 1);
  }

  void render() {
    picture_.resize(static_cast<std::size_t>(kWidth) * kHeight);
    for (int v = 0; v < kHeight; ++v) {
      const float* noise = noise_.data() + random_() % kNoiseSize;
      for (int u = 0; u < kWidth; ++u) {
        const int i = u - patch_u_;
        const int j = v - patch_v_;
        const bool near = i >= 0 && j >= 0 && i < kPatch && j < kPatch;
        const double c = near ? static_cast<double>(cover_[placeOf(i, j)]) : 0.0;
        const double grey = light(u, v) * (1.0 - label_.contrast * c) + label_.noise * static_cast<double>(noise[u]);
        picture_[static_cast<std::size_t>(v) * kWidth + static_cast<std::size_t>(u)] =
            static_cast<std::uint8_t>(std::clamp(std::lround(grey), 0L, 255L));
      }
    }
  }

  LabelledFingers fingers_;
  std::mt19937_64 random_;
  std::vector<float> noise_;
  std::vector<float> cover_;
  std::vector<std::uint8_t> picture_;
  FrameLabel label_;
  double level_ = 200.0;
  double gradient_ = 0.0;
  double slope_u_ = 1.0;
  double slope_v_ = 0.0;
  double fall_off_ = 0.0;
  double reach_ = 110.0;
  double centre_u_ = 0.0;
  double centre_v_ = 0.0;
  int patch_u_ = 0;
  int patch_v_ = 0;
  int made_ = 0;
};

}  // namespace fyd::bench
