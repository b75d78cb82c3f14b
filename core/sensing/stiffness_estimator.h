// Stiffness of the cloth under the finger from force and indentation sampled at different rates [thesis §4.1.4].
//
// slope (default): F = k·δ + c + noise. A Kalman filter of (k, c): k wanders at a given pace, because the motors change
//   it while the finger holds still; c, the remaining tare error, starts at 0 with a small uncertainty at each touch,
//   so that it is used only when δ varies enough to tell it from k. Outliers weigh less (Huber). The reported
//   uncertainty adds the indentation's own, which is common to all samples of a press: σ² = P + (kσ_δ/δ)².
// thesis: k = F/δ, held while δ is too small to divide by.
//
// "Not observable" while untouched, while force or indentation is too small, invalid or stale, or while the
// uncertainty is above the limit; then the last value is held. A new touch starts afresh.
// Stability: may change
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/base/api.h"
#include "core/base/message.h"
#include "core/base/parameter.h"
#include "core/base/timed.h"
#include "core/sensing/indentation.h"

namespace fyd::sensing {

enum class StiffnessMode : std::uint8_t { slope, thesis };
inline constexpr std::array<std::string_view, 2> kStiffnessModeNames = {"slope", "thesis"};

struct StiffnessParameters {
  StiffnessMode mode = StiffnessMode::slope;
  double minimum_indentation_mm = 1.0;
  double minimum_force_N = 0.1;
  double pace_N_per_mm_per_sqrt_s = 0.2;
  double force_noise_N = 0.03;
  double tare_sigma_N = 0.02;
  double relative_sigma_limit = 0.35;

  template <class Visitor>
  void describe(Visitor& v) {
    v.choice("sensing.stiffness_mode", mode, kStiffnessModeNames,
             {.name = sentence("Stiffness mode"),
              .help = sentence("slope fits force against indentation with uncertainty; thesis is the bare ratio."),
              .live = true});
    v.real("sensing.stiffness_minimum_indentation_mm", minimum_indentation_mm,
           {.name = sentence("Stiffness minimum indentation"),
            .unit = "mm",
            .minimum = 0.1,
            .maximum = 20,
            .help = sentence("Stiffness is not observable with less indentation than this."),
            .live = true});
    v.real("sensing.stiffness_minimum_force_N", minimum_force_N,
           {.name = sentence("Stiffness minimum force"),
            .unit = "N",
            .minimum = 0.01,
            .maximum = 5,
            .help = sentence("Stiffness is not observable with less force than this."),
            .live = true});
    v.real("sensing.stiffness_pace", pace_N_per_mm_per_sqrt_s,
           {.name = sentence("Stiffness pace"),
            .unit = "N/mm/√s",
            .minimum = 0.001,
            .maximum = 10,
            .help = sentence("How fast the cloth's stiffness may wander while the motors move."),
            .live = true});
    v.real("sensing.force_noise_N", force_noise_N,
           {.name = sentence("Force noise"),
            .unit = "N",
            .minimum = 0.001,
            .maximum = 2,
            .help = sentence("Load cell: noise of one reading."),
            .live = true});
    v.real("sensing.force_tare_sigma_N", tare_sigma_N,
           {.name = sentence("Force tare sigma"),
            .unit = "N",
            .minimum = 0,
            .maximum = 2,
            .help = sentence("Load cell: how far its zero may be off."),
            .live = true});
    v.real("sensing.stiffness_relative_sigma_limit", relative_sigma_limit,
           {.name = sentence("Stiffness relative sigma limit"),
            .minimum = 0.01,
            .maximum = 2,
            .help = sentence("Stiffness is not observable while its relative uncertainty is above this."),
            .live = true});
  }
};

enum class StiffnessReason : std::uint8_t {
  observed,
  untouched,
  indentation_unavailable,
  force_unavailable,
  indentation_too_small,
  force_too_small,
  uncertain,  ///< relative uncertainty above the limit
};

[[nodiscard]] FYD_API std::string_view toString(StiffnessReason reason);

struct StiffnessEstimate {
  double stiffness_N_per_mm = 0.0;  ///< last observed value; meaningful once known; 0…kLargest, always finite
  double sigma_N_per_mm = 0.0;
  bool known = false;       ///< a value was observed since the start
  bool observable = false;  ///< observed now
  StiffnessReason reason = StiffnessReason::untouched;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(stiffness_N_per_mm, sigma_N_per_mm, known, observable, within(reason, StiffnessReason::uncertain));
  }
};

class FYD_API StiffnessEstimator {
 public:
  explicit StiffnessEstimator(const StiffnessParameters& parameters = {});
  void configure(const StiffnessParameters& parameters);
  /// A force older than this is unavailable.
  void setMaximumAge(Duration force);

  /// @param force_N when and what; NaN when invalid
  [[nodiscard]] StiffnessEstimate step(Instant now, const Timed<double>& force_N,
                                       const IndentationEstimate& indentation);

  void reset();

  static constexpr double kLargest_N_per_mm = 100.0;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(slope_, intercept_, slope_variance_, covariance_, intercept_variance_, started_, last_force_, last_learned_,
            estimate_);
  }

 private:
  void restart();
  void observe(const Timed<double>& force_N, const IndentationEstimate& indentation);
  void learn(double dt_s, double force_N, double depth_mm, double depth_sigma_mm);

  StiffnessParameters parameters_;
  Duration maximum_age_ = std::chrono::milliseconds(100);
  double slope_ = 0.0;      // k
  double intercept_ = 0.0;  // c
  double slope_variance_ = 0.0;
  double covariance_ = 0.0;
  double intercept_variance_ = 0.0;
  bool started_ = false;  // of this touch
  std::uint64_t last_force_ = 0;
  Instant last_learned_{};
  StiffnessEstimate estimate_;
};

}  // namespace fyd::sensing
