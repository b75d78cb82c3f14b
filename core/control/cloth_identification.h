// Identifies the cloth under the finger and the sensors' dynamics from a recorded excitation.
//
// Model of the measured stiffness, in logarithms (see stiffness_controller.h):
//
//   ln k̂(t) = ln S + g·[ ln law(θ) through a dead time T and one time constant τ ](t) + noise
//
// S is the cloth's scale, g is 1 when the law's shape holds on this cloth. For each T and τ of a grid, S and g follow
// by least squares; the best pair is refined on a finer grid around it.
// Stability: may change
#pragma once

#include <span>

#include "core/base/api.h"
#include "core/base/error.h"
#include "core/control/control_parameters.h"

namespace fyd::control {

/// One instant of the excitation, rising in time.
struct TuneSample {
  double time_s = 0.0;
  double angle_deg = 0.0;           ///< measured stretch
  double stiffness_N_per_mm = 0.0;  ///< measured, divided by the place factor; NaN while not observable
};

struct IdentifiedCloth {
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
[[nodiscard]] FYD_API double excitationAngle_deg(double time_s, const ControlParameters& parameters);
inline constexpr double kExcitation_s = 12.0;

/// @return an error that says what the recording misses: samples (100 observable ones over 2 s), rising times,
///         excitation (the law must change by 5 %), or a model that explains half of the measured variance
[[nodiscard]] FYD_API Result<IdentifiedCloth> identifyCloth(std::span<const TuneSample> recording,
                                                            const ControlParameters& parameters);

}  // namespace fyd::control
