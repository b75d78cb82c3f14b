// The passive local model (coupling.h).
//
// At the hand: force = K·(x − surface) + B·v, never pulling, of a locally stored surface. Its update from the messages
// puts no energy into the hand: the surface appears no higher than the hand is, rises only as the hand withdraws, and
// stiffens only out of contact; it may sink and soften at any time, slowly. B damps the hand on the surface, and
// dissipates the energy that a force held for a millisecond generates (B > K·1 ms/2). Finally, the energy is observed,
// and a force that would give back more than was put in is reduced. Far end: the device follows the hand's positions,
// and estimates the surface it touches (surface_estimator.h).
#pragma once

#include "core/teleop/coupling/coupling.h"
#include "core/teleop/coupling/port_energy.h"
#include "core/teleop/coupling/surface_estimator.h"

namespace fyd::teleop {

class ModelHandEnd final : public CouplingEnd {
 public:
  explicit ModelHandEnd(const CouplingSettings& settings) : settings_(settings) {}

  void receive(const CouplingMessage& message) override;
  [[nodiscard]] double step(const EndState& state) override;
  [[nodiscard]] CouplingMessage message() const override;
  [[nodiscard]] CouplingTelemetry telemetry() const override;

  /// How fast a surface sinks and softens while it is pressed.
  static constexpr double kSinking_m_per_s = 0.2, kSofteningTime_s = 0.1;
  /// Damping ratio of a hand of 1 kg on the surface.
  static constexpr double kDampingRatio = 0.5;

 private:
  void follow(double position_m, double dt);

  CouplingSettings settings_;
  PortEnergy port_;
  double time_s_ = 0.0, position_m_ = 0.0;
  bool heard_ = false;
  CouplingMessage newest_;
  bool has_surface_ = false;
  double surface_m_ = 0.0;
  double stiffness_ = 0.0;
};

class ModelFarEnd final : public CouplingEnd {
 public:
  explicit ModelFarEnd(const CouplingSettings& settings) : settings_(settings) {}

  void receive(const CouplingMessage& message) override;
  [[nodiscard]] double step(const EndState& state) override;
  [[nodiscard]] CouplingMessage message() const override;
  [[nodiscard]] CouplingTelemetry telemetry() const override { return {}; }

 private:
  CouplingSettings settings_;
  SurfaceEstimator estimator_;
  double time_s_ = 0.0, position_m_ = 0.0;
  bool heard_ = false;
  CouplingMessage newest_;
};

}  // namespace fyd::teleop
