// Two linked devices, one axis of them: a hand's device and one far away, each with the other's messages, late.
//
// Positive is forward, into what may stand there. A hand's force F is what the hand exerts on its device; the device
// pushes back with F. Energy is what the hand has put into the coupling, ∫F·v dt: a coupling that never gives back more
// is passive, and cannot shake whoever holds it.
//
//   spring  the paper's: both ends are pulled to where the other was; the network acts as a spring
//   tdpa    the same, with the energy at both ends observed, and a damper that takes away what was never put in
//           (time-domain passivity: Hannaford and Ryu 2002; Ryu, Artigas, Preusche 2010)
//   model   the far surface is estimated where it is touched, and felt from an estimate at the hand, at 1 kHz: the
//           delay is outside of the loop of contact (model-mediated; Mitra and Niemeyer 2008)
//
// Every end is stepped at 1 kHz, allocates nothing, reads no clock, and answers what is not finite with no force.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string_view>

#include "core/base/error.h"

namespace fyd::teleop {

enum class CouplingChoice : std::uint8_t { spring, tdpa, model };
inline constexpr std::array<std::string_view, 3> kCouplingNames = {"spring", "tdpa", "model"};
/// @return an error with the names when there is none of that name
[[nodiscard]] Result<CouplingChoice> couplingNamed(std::string_view name);

struct CouplingSettings {
  double stiffness_N_per_m = 1000.0;  ///< of the spring between an end and where the other was
  double damping_N_s_per_m = 60.0;    ///< of the far device, against its own motion
  double most_force_N = 20.0;         ///< of either end
};

/// What one end tells the other.
struct CouplingMessage {
  double date_s = 0.0;  ///< the sender's; an older one than the newest is passed over
  double position_m = 0.0;
  double energy_J = 0.0;  ///< that has flowed into the network at this end, never less than before
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

/// Devices stand on tables: what is further away or faster than this is no state of one.
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

[[nodiscard]] std::unique_ptr<CouplingEnd> makeHandEnd(CouplingChoice choice, const CouplingSettings& settings);
[[nodiscard]] std::unique_ptr<CouplingEnd> makeFarEnd(CouplingChoice choice, const CouplingSettings& settings);

/// The paper's virtual tangential force: against a hand that is faster than the far robot may move, and steeply so:
/// 1 N at 10 % above the limit, growing with the square of the excess.
/// @return N, against the motion; 0 up to the limit, and where an argument is not finite or the limit is not positive
[[nodiscard]] double overspeedForce(double velocity_m_per_s, double limit_m_per_s);

}  // namespace fyd::teleop
