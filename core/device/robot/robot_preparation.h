// What a robot end does before it calls the touchpad: waits until the arm follows, probes the material, and takes the
// mean acceleration at rest: of 200 measurements, or of those within a second of an arm that measures more slowly than
// it is asked. Pure stepping, in real or virtual time: the caller exchanges `target` with the arm and reports the result
// with `succeeded` or `failed`.
#pragma once

#include "core/device/robot/material_probe.h"

namespace fyd::device {

class RobotPreparation {
 public:
  /// @param probe_material false: the outcome is `skipped` and the stiffness `known_stiffness_N_per_mm`
  RobotPreparation(const ProbeSettings& probe, bool probe_material, double known_stiffness_N_per_mm);

  [[nodiscard]] const Vec3& target() const { return target_mm_; }
  void succeeded(const RobotReadings& readings, Instant now);
  /// The arm did not follow: waited for at first, aborts a probe that has begun.
  void failed(Instant now);
  /// The operator's stop: a probe that has begun goes back to its start, anything else ends at once.
  void abort();

  [[nodiscard]] bool finished() const { return phase_ == Phase::finished; }
  [[nodiscard]] ProbeOutcome outcome() const { return outcome_; }
  [[nodiscard]] double stiffness_N_per_mm() const { return stiffness_N_per_mm_; }
  /// Mean of the finite readings at rest; 0 when there was none.
  [[nodiscard]] const Vec3& restAcceleration_g() const { return rest_acceleration_g_; }

 private:
  enum class Phase : std::uint8_t { waiting, probing, resting, finished };

  void advanceProbe(Instant now);
  void beginRest(Instant now);
  void rest(const Vec3& acceleration_g, Instant now);

  ProbeSettings settings_;
  bool probe_material_;
  bool aborted_ = false;
  Phase phase_ = Phase::waiting;
  MaterialProbe probe_;
  RobotReadings readings_;
  Vec3 target_mm_;
  ProbeOutcome outcome_ = ProbeOutcome::skipped;
  double stiffness_N_per_mm_;
  Vec3 rest_sum_g_;
  int rest_taken_ = 0;
  int rest_tried_ = 0;
  Instant rest_began_{};
  Instant taken_{};  // of the newest readings
  Vec3 rest_acceleration_g_;
};

}  // namespace fyd::device
