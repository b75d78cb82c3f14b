#include "core/device/robot/robot_preparation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fyd::device {
namespace {

constexpr int kRestReadings = 200;
constexpr Duration kLongestRest = std::chrono::seconds(1);

}  // namespace

RobotPreparation::RobotPreparation(const ProbeSettings& probe, bool probe_material, double known_stiffness_N_per_mm)
    : settings_(probe),
      probe_material_(probe_material),
      probe_(probe, {}),
      stiffness_N_per_mm_(std::isfinite(known_stiffness_N_per_mm) ? std::max(known_stiffness_N_per_mm, 0.0) : 0.0) {}

void RobotPreparation::succeeded(const RobotReadings& readings, Instant now) {
  readings_ = readings;
  const bool is_new = std::exchange(taken_, readings.taken) != readings.taken;
  switch (phase_) {
    case Phase::waiting:
      if (readings.position_mm.finite()) target_mm_ = readings.commanded_mm.value_or(readings.position_mm);
      probe_ = MaterialProbe(settings_, target_mm_);
      if (aborted_) {
        phase_ = Phase::finished;
      } else if (probe_material_) {
        phase_ = Phase::probing;
      } else {
        beginRest(now);
      }
      break;
    case Phase::probing: advanceProbe(now); break;
    case Phase::resting:
      // What was measured once counts once, however often it is read; a single measurement for the whole rest as well.
      if (is_new || (rest_taken_ == 0 && now - rest_began_ >= kLongestRest)) {
        rest(readings.acceleration_g, now);
      } else if (now - rest_began_ >= kLongestRest) {
        rest({std::nan(""), 0.0, 0.0}, now);
      }
      break;
    case Phase::finished: break;
  }
}

void RobotPreparation::failed(Instant now) {
  if (phase_ == Phase::probing) {
    probe_.abort();
    advanceProbe(now);
  } else if (phase_ == Phase::resting) {
    rest({std::nan(""), 0.0, 0.0}, now);
  }
}

void RobotPreparation::abort() {
  aborted_ = true;
  if (phase_ == Phase::probing) {
    probe_.abort();
  } else {
    phase_ = Phase::finished;
  }
}

void RobotPreparation::advanceProbe(Instant now) {
  target_mm_ = probe_.step(readings_, now);
  if (!probe_.finished()) return;
  outcome_ = probe_.outcome();
  stiffness_N_per_mm_ = probe_.stiffness_N_per_mm();
  if (aborted_) {
    phase_ = Phase::finished;
  } else {
    beginRest(now);
  }
}

void RobotPreparation::beginRest(Instant now) {
  phase_ = Phase::resting;
  rest_began_ = now;
}

void RobotPreparation::rest(const Vec3& acceleration_g, Instant now) {
  if (acceleration_g.finite()) {
    rest_sum_g_ = rest_sum_g_ + acceleration_g;
    ++rest_taken_;
  }
  if (++rest_tried_ < kRestReadings && now - rest_began_ < kLongestRest) return;
  if (rest_taken_ > 0) rest_acceleration_g_ = (1.0 / rest_taken_) * rest_sum_g_;
  phase_ = Phase::finished;
}

}  // namespace fyd::device
