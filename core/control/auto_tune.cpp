#include "core/control/auto_tune.h"

#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"

namespace fyd::control {
namespace {

constexpr double kFastest_s = 0.2;
constexpr double kSlowest_s = 10.0;
constexpr double kLonger = 1.05;    // each time constant than the one before
constexpr int kTimeConstants = 81;  // up to the last that is not beyond the slowest
constexpr double kLeastGainMargin = 2.0;
constexpr double kLeastPhaseMargin_deg = 60.0;

ControlParameters tuned(const ControlParameters& present, const IdentifiedCloth& cloth, double lambda_s) {
  ControlParameters p = present;
  p.mode = ControlMode::normal;  // the gains are of this mode, whichever the touchpad runs
  p.ki_per_s = 1.0 / (std::max(1.0, cloth.shape_gain) * lambda_s);
  p.kp = kMotorLag_s * p.ki_per_s;
  p.kd_s = 0.0;
  p.measurement_lag_s = cloth.lag_s;
  p.measurement_delay_s = cloth.delay_s;
  p.noise_correlation_s = cloth.noise_correlation_s;
  return p;
}

bool keepsMargins(const IdentifiedCloth& cloth, const ControlParameters& p) {
  for (const double gain : {0.7, 1.0, 1.3}) {
    for (const double lag : {0.7, 1.0, 1.3}) {
      for (const double more_delay_s : {0.0, 0.05}) {
        IdentifiedCloth other = cloth;
        other.shape_gain *= gain;
        other.lag_s *= lag;
        other.delay_s += more_delay_s;
        const LoopMargins margins = loopMargins(other, p);
        if (margins.gain_margin < kLeastGainMargin || margins.phase_margin_deg < kLeastPhaseMargin_deg) return false;
      }
    }
  }
  return true;
}

}  // namespace

Result<TuneProposal> proposeGains(std::span<const TuneSample> recording, const ControlParameters& present,
                                  const TuneProgress& progress) {
  constexpr double kIdentified = 0.5;  // about half of the time goes into the fit
  const auto ended = [&](double done) { return progress && !progress(done); };
  if (ended(0.0)) return fail("auto-tune: cancelled");
  const auto cloth = identifyCloth(recording, present);
  if (!cloth) return tl::unexpected(cloth.error());
  double lambda_s = kFastest_s;
  for (int i = 0; i < kTimeConstants; ++i, lambda_s *= kLonger) {
    const double tried = math::log(lambda_s / kFastest_s) / math::log(kSlowest_s / kFastest_s);
    if (ended(kIdentified + (1 - kIdentified) * tried)) return fail("auto-tune: cancelled");
    const ControlParameters proposed = tuned(present, *cloth, lambda_s);
    if (!keepsMargins(*cloth, proposed)) continue;
    ControlParameters before = present, after = proposed;
    before.mode = proposed.mode;
    after.mode = present.mode;
    return TuneProposal{*cloth, after, predictLoop(*cloth, before), predictLoop(*cloth, proposed)};
  }
  return fail(
      "auto-tune: no time constant up to {} s keeps gain margin {} and phase margin {}° (dead time {:.3f} s, lag "
      "{:.3f} s, noise {:.1f} %)",
      kSlowest_s, kLeastGainMargin, kLeastPhaseMargin_deg, cloth->delay_s, cloth->lag_s,
      100 * cloth->residual_rms_relative);
}

}  // namespace fyd::control
