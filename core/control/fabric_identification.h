// What a recorded excitation says of the fabric under the finger and of the sensors that watch it.
//
// Model of what the controller sees, in logarithms (see stiffness_controller.h):
//
//   ln k̂(t) = ln S + g·[ ln law(θ) through a dead time T and one time constant τ ](t) + noise
//
// S is the fabric's scale, g is 1 when the law's shape holds on this fabric. For each T and τ of a grid, S and g follow
// by least squares; the best pair is refined on a finer grid around it.
#pragma once

#include <span>

#include "core/base/error.h"
#include "core/control/control_parameters.h"

namespace fyd::control {

/// One instant of the excitation, rising in time.
struct TuneSample {
  double time_s = 0.0;
  double angle_deg = 0.0;           ///< measured stretch, or commanded when the encoders are silent
  double stiffness_N_per_mm = 0.0;  ///< measured, over the place's factor; NaN while not observable
};

struct IdentifiedFabric {
  double scale = 1.0;                  ///< S
  double shape_gain = 1.0;             ///< g
  double delay_s = 0.0;                ///< T
  double lag_s = 0.0;                  ///< τ
  double slope_N_per_mm_deg = 0.0;     ///< dk/dθ, mean over the excited span
  double residual_rms_relative = 0.0;  ///< of the fit: the noise of k̂ when the model holds
  double noise_correlation_s = 0.0;    ///< Tc: integral of the residual's autocorrelation
};

/// The safe excitation: a staircase of stretch through the middle half of the travel, at a third of the rate limit at
/// most, while the finger holds still. Repeats after kExcitation_s.
[[nodiscard]] double excitationAngle_deg(double time_s, const ControlParameters& parameters);
inline constexpr double kExcitation_s = 12.0;

/// @return an error that says what the recording lacks: samples (100 observable ones over 2 s), time that rises,
///         excitation (the law must move by 5 %), or a model that explains the half of what was seen
[[nodiscard]] Result<IdentifiedFabric> identifyFabric(std::span<const TuneSample> recording,
                                                      const ControlParameters& parameters);

}  // namespace fyd::control
