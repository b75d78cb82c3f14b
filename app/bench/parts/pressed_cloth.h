// Simulated sensor readings of a finger that presses the cloth, with known true values: for the tests and the benchmark
// of the indentation.
//
// Distance dᵢ = 100 mm − s(xᵢ, yᵢ)·δ, force F: of the ideal cloth, s from the stretched membrane and F = k·δ; of the
// others, from their tables (core/sim/cloth/cloth.h) at the stretch that `stiffness_N_per_mm` names, with the contact's
// area and place as the camera sees them. Through the thesis curve to volts, noise of the sensors, 12-bit code,
// every 16.5 ms; the camera's position every 33 ms with 0.1 mm of noise, 20 ms late; force at 122 Hz with 5 mN of
// noise. Steps of 1 ms. Deterministic from the seed.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <random>

#include "core/base/timed.h"
#include "core/sensing/finger_types.h"
#include "core/sensing/ir_distance.h"
#include "core/sensing/membrane.h"
#include "core/sensing/readings.h"
#include "core/sim/cloth/cloth.h"
#include "core/sim/touchpad/picture.h"

namespace fyd::bench {

struct PressedClothOptions {
  double x_mm = 0.0;
  double y_mm = 0.0;
  double depth_mm = 6.0;
  double press_s = 0.2;  ///< from the surface to the depth
  double touch_at_s = 0.2;
  double wander_mm = 0.5;  ///< slow sine on the depth while holding
  sim::ClothKind cloth = sim::ClothKind::ideal;
  sim::FingerKind finger = sim::FingerKind::sphere;
  double finger_radius_mm = 7.0;  ///< of the ideal cloth's disc
  double ir_noise_mV = 10.0;
  double stiffness_N_per_mm = 0.6;
  std::uint64_t seed = 1;
};

class PressedCloth {
 public:
  explicit PressedCloth(const PressedClothOptions& options)
      : o_(options), membrane_(50.0, 35.0, options.finger_radius_mm), random_(options.seed) {
    if (o_.cloth != sim::ClothKind::ideal) {
      cloth_.emplace(sim::SimParameters{.cloth = o_.cloth, .finger = o_.finger});
      angle_deg_ = sim::nominalAngle(o_.stiffness_N_per_mm);
    }
    for (std::size_t i = 0; i < 3; ++i) shape_[i] = membrane_.shape(kX[i], kY[i], o_.x_mm, o_.y_mm);
  }

  /// One millisecond.
  void step() {
    time_s_ = 1e-3 * static_cast<double>(++steps_);
    now = instantAt(time_s_);
    const double since = time_s_ - o_.touch_at_s;
    depth_mm = since <= 0.0 ? 0.0
                            : o_.depth_mm * std::min(1.0, since / o_.press_s) +
                                  (since > o_.press_s ? o_.wander_mm * std::sin(2.5 * (since - o_.press_s)) : 0.0);
    const sim::FingerState state{
        .x_mm = o_.x_mm, .y_mm = o_.y_mm, .indentation_mm = depth_mm, .lifted = !(depth_mm > 0.0)};
    if (time_s_ >= next_ir_s_) {
      next_ir_s_ += 0.0165;
      sensing::IrCounts counts;
      for (std::size_t i = 0; i < 3; ++i) {
        const double sunk_mm = cloth_ ? cloth_->deflection_mm(kX[i], kY[i], state) : shape_[i] * depth_mm;
        const double volts = curve_.voltsAt(100.0 - sunk_mm) + 1e-3 * o_.ir_noise_mV * normal_(random_);
        const double code = std::clamp(volts * sensing::kAdcCodes / sensing::kAdcReference_V, 0.0, 4095.0);
        (void)counts.push(static_cast<std::uint16_t>(std::lround(code)));
      }
      ir.set(counts, now);
    }
    if (time_s_ >= next_picture_s_) {
      next_picture_s_ += 1.0 / 30.0;
      sensing::FingerDetection seen;
      seen.contact = time_s_ - 0.02 > o_.touch_at_s;
      sim::Spot spot{o_.x_mm, o_.y_mm, std::numbers::pi * o_.finger_radius_mm * o_.finger_radius_mm};
      if (cloth_) {
        const sim::Pressing contact = sim::Cloth(*cloth_).press(angle_deg_, state, 0.0);
        spot = sim::seenFromBelow({o_.x_mm + contact.centre_x_mm, o_.y_mm + contact.centre_y_mm, contact.area_mm2},
                                  std::max(0.0, depth_mm), 100.0);
      }
      seen.area_mm2 = spot.area_mm2;
      seen.x_mm = spot.x_mm + 0.1 * normal_(random_);
      seen.y_mm = spot.y_mm + 0.1 * normal_(random_);
      finger.set(seen, now - std::chrono::milliseconds(20));
    }
    if (time_s_ >= next_force_s_) {
      next_force_s_ += 1.0 / 122.0;
      force_N.set(stiffness_N_per_mm() * depth_mm + 0.005 * normal_(random_), now);
    }
  }

  /// True stiffness of the present press; on the ideal cloth it is the same everywhere.
  [[nodiscard]] double stiffness_N_per_mm() const {
    if (!cloth_) return o_.stiffness_N_per_mm;
    return cloth_->stiffness(angle_deg_, {o_.x_mm, o_.y_mm, depth_mm, !(depth_mm > 0.0)});
  }
  void setStiffness(double stiffness_N_per_mm) {
    o_.stiffness_N_per_mm = stiffness_N_per_mm;
    angle_deg_ = sim::nominalAngle(stiffness_N_per_mm);
  }
  [[nodiscard]] double sinceTouch_s() const { return time_s_ - o_.touch_at_s; }

  Instant now{};
  double depth_mm = 0.0;  ///< truth
  Timed<sensing::IrCounts> ir;
  Timed<sensing::FingerDetection> finger;
  Timed<double> force_N;

 private:
  static constexpr std::array<double, 3> kX = {-22.0, 0.0, 22.0};
  static constexpr std::array<double, 3> kY = {-3.0, 27.0, -3.0};

  PressedClothOptions o_;
  sensing::Membrane membrane_;
  std::optional<sim::Cloth> cloth_;
  double angle_deg_ = 0.0;
  sensing::IrDistance curve_;
  std::array<double, 3> shape_{};
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::uint64_t steps_ = 0;
  double time_s_ = 0.0;
  double next_ir_s_ = 0.0;
  double next_picture_s_ = 0.0;
  double next_force_s_ = 0.0;
};

}  // namespace fyd::bench
