// Bilateral coupling of one axis of two linked devices: a hand's device and a far one, each with the other's delayed
// messages.
//
// Positive is forward, towards a surface. F is the hand's force on its device; the device pushes back with F. Energy is
// the hand's work on the coupling, ∫F·v dt: a coupling that never gives back more is passive, and cannot oscillate by
// itself.
//
//   spring  the paper's: each end is pulled to the other's delayed position by a spring
//   tdpa    the same, with a passivity observer at both ends, and a damper that dissipates energy that was not put in
//           (time-domain passivity [Hannaford 2002] [Ryu 2010])
//   model   the surface is estimated at the far end and rendered from that estimate at the hand, at 1 kHz: the delay is
//           outside of the contact loop (model-mediated [Mitra 2008])
//
// Every end is stepped at 1 kHz, allocates nothing, reads no clock, and gives no force for inputs that are not finite.
// Stability: may change
#pragma once

#include <cmath>

#include "core/base/api.h"

namespace fyd::teleop {

struct CouplingSettings {
  double stiffness_N_per_m = 1000.0;  ///< of the spring between an end and where the other was
  double damping_N_s_per_m = 60.0;    ///< of the far device, against its own motion
  double most_force_N = 20.0;         ///< of either end
};

/// Message from one end to the other.
struct CouplingMessage {
  double date_s = 0.0;  ///< the sender's; messages older than the newest are ignored
  double position_m = 0.0;
  double energy_J = 0.0;  ///< that has flowed into the network at this end since it linked
  bool touching = false;  ///< the far end: something is touched
  bool knows_surface = false;
  double surface_m = 0.0;  ///< where it begins
  double stiffness_N_per_m = 0.0;
};

struct EndState {
  double time_s = 0.0;
  double position_m = 0.0;
  double velocity_m_per_s = 0.0;
  double measured_N = 0.0;  ///< the far end: force on what it touches; the hand's end: not used
};

struct CouplingTelemetry {
  double energy_J = 0.0;      ///< put in at this end less what came back
  double dissipated_J = 0.0;  ///< by the coupling itself, so that it stays passive
};

/// Bounds of a state that a device on a table can have.
inline constexpr double kFurthest_m = 100.0, kFastest_m_per_s = 1000.0;
inline constexpr double kUsualStep_s = 0.001, kLongestStep_s = 0.010;
/// Both false for NaN.
[[nodiscard]] inline bool isPlace(double position_m) { return std::abs(position_m) <= kFurthest_m; }
[[nodiscard]] inline bool isSound(const EndState& state) {
  return std::isfinite(state.time_s) && isPlace(state.position_m) &&
         std::abs(state.velocity_m_per_s) <= kFastest_m_per_s;
}

class CouplingEnd {
 public:
  virtual ~CouplingEnd() = default;
  virtual void receive(const CouplingMessage& message) = 0;
  /// @return at the hand: the force that pushes the hand back, N; at the far end: the force that drives the device
  [[nodiscard]] virtual double step(const EndState& state) = 0;
  [[nodiscard]] virtual CouplingMessage message() const = 0;
  [[nodiscard]] virtual CouplingTelemetry telemetry() const = 0;

 protected:
  CouplingEnd() = default;
  CouplingEnd(const CouplingEnd&) = default;
  CouplingEnd& operator=(const CouplingEnd&) = default;
};

/// The paper's virtual tangential force against a hand that is faster than the far robot may move: 1 N at 10 % above
/// the limit, growing with the square of the excess.
/// @return N, against the motion; 0 up to the limit, and where an argument is not finite or the limit is not positive
[[nodiscard]] FYD_API double overspeedForce(double velocity_m_per_s, double limit_m_per_s);

}  // namespace fyd::teleop
