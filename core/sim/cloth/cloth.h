// The simulated cloth under the simulated finger: force, contact and shape, of the kind that sim.cloth names.
//
//   ideal      F = k(θ)·s·δ (ideal_cloth.h); the shape is that of the estimator (core/sensing/membrane.h), so measurements
//              on it test the program against its own formula. The camera sees ideal_cloth.h's spot
//   membrane,  F, contact and shape from a finite-strain solution for the finger that sim.finger names (cloth_table.h),
//   rollers    scaled by s. A stretch angle θ gives the pre-stretch at which a sphere of 8 mm, 3 mm deep in the middle,
//              meets the thesis' k(θ)
//
// For all kinds: hysteresis (ideal_cloth.h), viscosity F·(1 + τ·δ̇/δ), F never below 0, and slackening with time. A table is
// read when the first cloth that needs it is made.
#pragma once

#include <memory>

#include "core/sim/cloth/cloth_table.h"
#include "core/sim/cloth/ideal_cloth.h"
#include "core/sim/finger_path.h"
#include "core/sim/sim_parameters.h"

namespace fyd::sim {

class IdealShape;

class Cloth {
 public:
  explicit Cloth(const SimParameters& parameters);

  [[nodiscard]] ClothKind kind() const { return kind_; }

  /// Follows the finger. @param elapsed_s since the last time
  Pressing press(double angle_deg, const FingerState& finger, double elapsed_s);

  /// Force over indentation of a slow press, N/mm: the true value that a controller is judged by. Without a pressing
  /// finger: in the middle, 3 mm deep.
  [[nodiscard]] double stiffness(double angle_deg, const FingerState& finger) const;

  /// Deflection of the cloth at (x, y), mm.
  [[nodiscard]] double deflection_mm(double x_mm, double y_mm, const FingerState& finger) const;

 private:
  [[nodiscard]] Pressing atRest(double angle_deg, double x_mm, double y_mm, double depth_mm) const;

  ClothKind kind_;
  IdealCloth law_;
  double scale_;
  double slackens_per_s_;
  double left_ = 1.0;  ///< factor on the stiffness, by slackening
  double viscosity_s_;
  std::shared_ptr<const IdealShape> ideal_;
  const ClothTable* table_ = nullptr;
  double last_mm_ = 0.0;
};

}  // namespace fyd::sim
