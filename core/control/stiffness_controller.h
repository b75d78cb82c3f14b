// Holds the stiffness under the finger at the target by turning the rollers.
//
// Default mode, each step, with k* the target, k̂ the measured stiffness, θ the measured stretch and law(·) the static
// law in N/mm:
//
//   g                            place factor: how much stiffer the cloth is under this finger, at its place and depth,
//                                than where the law was calibrated; low-passed, so that noise of the finger's place
//                                does not reach the motors
//   L = lag(ln law(θ))           the law as the sensors see it: with their dead time and lag (lag_model.h)
//   ln S = trust(observer(ln k̂ − ln g − L))   how much stiffer this cloth is than calibrated
//   y = ln S + ln law(θ)         the present stiffness, without the sensors' noise and lag
//   c = PID(ln(k*/g) − y)        relative correction, with a dead band
//   stretch = law⁻¹(k*/g·eᶜ)     within travel and rate limits
//
// Feed-forward makes it fast: it needs no measurement. The logarithm makes the loop's gain the same at every stretch
// and on every cloth. The observer (scale_observer.h) averages as long as it takes to tell the cloth from the noise,
// so the PID may be quick without passing noise to the motors; scale_trust.h keeps the measurement's lasting error out
// of the correction. The integrator holds while the motors still travel.
//
// Thesis mode [thesis §4.1.4], every 100 ms, if k̂ > 0.1 and |k* − k̂| > 0.01: stretch = PID(k* − k̂) + rest, with rest
// the static law's angle of the first target.
// Stability: stable since 0.1
#pragma once

#include "core/base/api.h"
#include "core/base/time.h"
#include "core/control/control_parameters.h"
#include "core/control/lag_model.h"
#include "core/control/pid.h"
#include "core/control/scale_observer.h"
#include "core/control/scale_trust.h"
#include "core/control/static_law.h"

namespace fyd::control {

struct ControlInput {
  Instant now{};
  double target_N_per_mm = 0.0;    ///< NaN or ≤ 0: none, the stretch stays where it is
  double measured_N_per_mm = 0.0;  ///< used only while observable
  double measured_sigma_N_per_mm = 0.0;
  double place_factor = 1.0;  ///< g; not finite or ≤ 0: the last one is kept
  bool observable = false;    ///< the measured stiffness is of now; otherwise what was learned of the cloth is kept
  double measured_angle_deg = 0.0;
  bool measured_angle_known = false;
  bool enabled = false;  ///< false: the reference is held; the first enabled step starts from the measured angle
};

struct ControlOutput {
  double stretch_angle_deg = 0.0;  ///< reference, always finite and within travel
  double reachable_target_N_per_mm =
      0.0;                        ///< nearest to the target this cloth can give, as known so far; NaN: no target
  bool target_clamped = false;    ///< the target lies outside what the cloth can give
  bool at_limit = false;          ///< the reference is at an end of the travel
  bool holding = false;           ///< no target or not enabled: the reference is held
  double correction = 0.0;        ///< PID's part: relative in default mode, degrees in thesis mode
  double cloth_scale = 1.0;       ///< S: 1.3 is a cloth 30 % stiffer than calibrated; 1 while uncertain
  double measured_scale = 1.0;    ///< S as measured, before trust
  bool law_contradicted = false;  ///< the measurement asks for more than the calibration allows: the law alone is used
  bool contradiction_begins = false;
};

class FYD_API StiffnessController {
 public:
  explicit StiffnessController(const ControlParameters& parameters = {});

  /// Live changes; no allocation, no step of the reference because of gains. Points that
  /// `checkControlParameters` refuses are ignored.
  void configure(const ControlParameters& parameters);

  [[nodiscard]] ControlOutput step(const ControlInput& input);

  /// Forgets what was learned and starts from this stretch (NaN: the travel's lower end).
  void reset(double stretch_angle_deg);

  [[nodiscard]] const StaticLaw& law() const { return law_; }

  static constexpr std::uint16_t kStateVersion = 2;
  template <class Archive>
  void serialize(Archive& archive) {
    restore(archive, 1);
    archive(trust_, place_log_, place_known_);
  }
  /// 1: without place and trust, which are then as after a reset.
  template <class Archive>
  void restore(Archive& archive, std::uint16_t /*version*/) {
    archive(lag_, scale_, pid_, thesis_pid_, reference_deg_, clamped_, still_s_, rest_deg_, rest_known_, was_enabled_,
            was_observable_, started_, last_, thesis_next_);
  }

 private:
  void followPlace(const ControlInput& input, double dt_s);
  /// Where the stretch should be now.
  double desiredDefault(const ControlInput& input, double present_log, double dt_s);
  double desiredThesis(const ControlInput& input);
  void judgeReach(double target_N_per_mm, ControlOutput& output);

  ControlParameters parameters_;
  StaticLaw law_;
  LagModel lag_;  // ln law(θ) as the sensors have seen it
  ScaleObserver scale_;
  ScaleTrust trust_;
  double place_log_ = 0.0;    // ln g
  bool place_known_ = false;  // in this touch
  Pid pid_;
  Pid thesis_pid_;
  double reference_deg_ = 0.0;
  bool clamped_ = false;
  double still_s_ = 0.0;  // since the rollers reached the reference
  double rest_deg_ = 0.0;
  bool rest_known_ = false;
  bool was_enabled_ = false;
  bool was_observable_ = false;
  bool started_ = false;
  Instant last_{};
  Instant thesis_next_{};
};

}  // namespace fyd::control
