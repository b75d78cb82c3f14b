// The robot's stiffness probe [thesis §4.2]: down in steps of 1 mm with a dwell after each; contact when the force
// exceeds a threshold; a sample of force and depth at every step from first contact on, up to ten; back to the start.
//
// Pure stepping: `step` takes the readings and the time and gives the target for Robot::exchange.
//
// Estimate, from samples i = 0 … n−1 with force Fᵢ and depth dᵢ counted from the first contact (d₀ = 0):
//   slope   least-squares slope of F over d; the force at first contact and the depth before it cancel (default)
//   mean    Σ_{i≥1} (Fᵢ/dᵢ) / (n − 1): the thesis' mean with the right divisor; still too high, because F₀ > 0 at d₀ =
//   0 thesis  Σ_{i≥1} (Fᵢ/dᵢ) / n as printed: the first sample, a division by zero, is left out of the sum only
// The printed limit of travel compares metres with 10 and never stops; here travel, force and time have hard limits.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/batch.h"
#include "core/base/error.h"
#include "core/base/time.h"
#include "core/base/vec3.h"
#include "core/device/robot/robot.h"

namespace fyd::device {

enum class ProbeEstimate : std::uint8_t { slope, mean, thesis };

struct ProbeSettings {
  double step_mm = 1.0;
  double dwell_s = 0.5;
  double contact_threshold_N = 0.8;
  int samples = 10;               ///< 2…32
  double travel_limit_mm = 25.0;  ///< below the start; never exceeded by a target
  double force_limit_N = 10.0;    ///< above it the probe goes back at once
  double time_limit_s = 60.0;
  ProbeEstimate estimate = ProbeEstimate::slope;
};

/// @return an error that names the first setting that is no number above 0, where a limit would limit nothing
[[nodiscard]] Result<void> checkProbe(const ProbeSettings& settings);

enum class ProbePhase : std::uint8_t { descending, retreating, finished };

enum class ProbeOutcome : std::uint8_t {
  measured,     ///< stiffness is known
  no_contact,   ///< no force above the threshold within the travel limit: stiffness 0
  too_few,      ///< a limit was reached before two depths were sampled: stiffness 0
  bad_reading,  ///< position or force not finite: stiffness 0
  timed_out,    ///< the arm did not get there in time: stiffness 0
  aborted,      ///< by the caller
  skipped,      ///< not wanted: stiffness as the operator gave it
};
[[nodiscard]] std::string_view toString(ProbeOutcome outcome);

class MaterialProbe {
 public:
  static constexpr std::size_t kMaximumSamples = 32;

  /// @param start where the robot stands; the probe goes straight down from there and returns to it
  MaterialProbe(const ProbeSettings& settings, const Vec3& start_mm);

  /// @return the target for the robot, mm: finite, never above the start nor below the travel limit
  const Vec3& step(const RobotReadings& readings, Instant now);
  /// Goes back to the start without a result.
  void abort();

  [[nodiscard]] ProbePhase phase() const { return phase_; }
  [[nodiscard]] bool finished() const { return phase_ == ProbePhase::finished; }
  [[nodiscard]] ProbeOutcome outcome() const { return outcome_; }
  /// N/mm, ≥ 0, finite; 0 unless measured.
  [[nodiscard]] double stiffness_N_per_mm() const { return stiffness_; }
  [[nodiscard]] std::size_t sampleCount() const { return samples_.size(); }
  [[nodiscard]] const Vec3& target() const { return target_mm_; }

 private:
  struct Sample {
    double depth_mm = 0.0;
    double force_N = 0.0;
  };

  void descend(const RobotReadings& readings, Instant now);
  void retreat(ProbeOutcome outcome);
  void conclude(ProbeOutcome when_too_few);
  [[nodiscard]] double estimate() const;

  ProbeSettings settings_;
  Vec3 start_mm_;
  Vec3 target_mm_;
  ProbePhase phase_ = ProbePhase::descending;
  ProbeOutcome outcome_ = ProbeOutcome::aborted;
  Batch<Sample, kMaximumSamples> samples_;
  double contact_z_mm_ = 0.0;
  double stiffness_ = 0.0;
  Instant started_{};
  Instant step_began_{};
  bool running_ = false;
};

}  // namespace fyd::device
