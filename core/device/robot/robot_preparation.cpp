#include "core/device/robot/robot_preparation.h"

#include <algorithm>
#include <cmath>

namespace fyd::device {
namespace {

constexpr int kRestReadings = 200;

}  // namespace

RobotPreparation::RobotPreparation(const ProbeSettings& probe, bool probe_material, double known_stiffness_N_per_mm)
    : settings_(probe),
      probe_material_(probe_material),
      probe_(probe, {}),
      stiffness_N_per_mm_(std::isfinite(known_stiffness_N_per_mm) ? std::max(known_stiffness_N_per_mm, 0.0) : 0.0) {}

void RobotPreparation::succeeded(const RobotReadings& readings, Instant now) {
  readings_ = readings;
  switch (phase_) {
    case Phase::waiting:
      if (readings.position_mm.finite()) target_mm_ = readings.commanded_mm.value_or(readings.position_mm);
      probe_ = MaterialProbe(settings_, target_mm_);
      if (aborted_) {
        phase_ = Phase::finished;
      } else {
        phase_ = probe_material_ ? Phase::probing : Phase::resting;
      }
      break;
    case Phase::probing: advanceProbe(now); break;
    case Phase::resting: rest(readings.acceleration_g); break;
    case Phase::finished: break;
  }
}

void RobotPreparation::failed(Instant now) {
  if (phase_ == Phase::probing) {
    probe_.abort();
    advanceProbe(now);
  } else if (phase_ == Phase::resting) {
    rest({std::nan(""), 0.0, 0.0});
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
  phase_ = aborted_ ? Phase::finished : Phase::resting;
}

void RobotPreparation::rest(const Vec3& acceleration_g) {
  if (acceleration_g.finite()) {
    rest_sum_g_ = rest_sum_g_ + acceleration_g;
    ++rest_taken_;
  }
  if (++rest_tried_ < kRestReadings) return;
  if (rest_taken_ > 0) rest_acceleration_g_ = (1.0 / rest_taken_) * rest_sum_g_;
  phase_ = Phase::finished;
}

}  // namespace fyd::device
