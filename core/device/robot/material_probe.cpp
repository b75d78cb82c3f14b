#include "core/device/robot/material_probe.h"

#include <algorithm>
#include <cmath>

#include "core/base/message.h"

namespace fyd::device {
namespace {

constexpr double kAtStart_mm = 0.5;
constexpr double kRetreatLimit_s = 5.0;
constexpr double kRigid_N_per_mm = 1000.0;  // upper limit of the estimate; also for unmeasurable depths
constexpr double kLeastDepth_mm = 1e-6;

}  // namespace

std::string_view toString(ProbeOutcome outcome) {
  switch (outcome) {
    case ProbeOutcome::measured: return sentence("measured");
    case ProbeOutcome::no_contact: return sentence("no contact within the travel limit");
    case ProbeOutcome::too_few: return sentence("limit reached before two samples");
    case ProbeOutcome::bad_reading: return sentence("reading not a number");
    case ProbeOutcome::timed_out: return sentence("time limit reached");
    case ProbeOutcome::aborted: return sentence("aborted");
    case ProbeOutcome::skipped: return sentence("skipped");
  }
  return sentence("unknown");
}

Result<void> checkProbe(const ProbeSettings& settings) {
  const auto above_0 = [](const char* name, double value) -> Result<void> {
    if (!(value > 0.0 && std::isfinite(value))) return fail("probe: {} is {}; expected a number above 0", name, value);
    return {};
  };
  for (const auto& good :
       {above_0("step_mm", settings.step_mm), above_0("dwell_s", settings.dwell_s),
        above_0("contact_threshold_N", settings.contact_threshold_N),
        above_0("travel_limit_mm", settings.travel_limit_mm), above_0("force_limit_N", settings.force_limit_N),
        above_0("time_limit_s", settings.time_limit_s)}) {
    if (!good) return good;
  }
  return {};
}

MaterialProbe::MaterialProbe(const ProbeSettings& settings, const Vec3& start_mm)
    : settings_(settings), start_mm_(start_mm.finite() ? start_mm : Vec3{}), target_mm_(start_mm_) {
  settings_.samples = std::clamp(settings_.samples, 2, static_cast<int>(kMaximumSamples));
}

const Vec3& MaterialProbe::step(const RobotReadings& readings, Instant now) {
  if (finished()) return target_mm_;
  if (!running_) {
    running_ = true;
    started_ = step_began_ = now;
  }
  if (phase_ == ProbePhase::descending) {
    if (!readings.position_mm.finite() || !std::isfinite(readings.force_N)) {
      retreat(ProbeOutcome::bad_reading);
    } else if (now - started_ > fromSeconds(settings_.time_limit_s)) {
      conclude(ProbeOutcome::timed_out);
    } else if (readings.force_N > settings_.force_limit_N) {
      conclude(ProbeOutcome::too_few);
    } else if (now - step_began_ >= fromSeconds(settings_.dwell_s)) {
      descend(readings, now);
    }
    if (phase_ == ProbePhase::retreating) step_began_ = now;
    return target_mm_;
  }
  const bool back = (readings.position_mm - start_mm_).norm() < kAtStart_mm;  // false when not a number
  if (back || now - step_began_ > fromSeconds(kRetreatLimit_s)) phase_ = ProbePhase::finished;
  return target_mm_;
}

void MaterialProbe::abort() {
  if (phase_ == ProbePhase::descending) retreat(ProbeOutcome::aborted);
}

// Called at the end of a dwell.
void MaterialProbe::descend(const RobotReadings& readings, Instant now) {
  if (readings.force_N > settings_.contact_threshold_N) {
    if (samples_.empty()) contact_z_mm_ = readings.position_mm.z;
    const bool stored =
        samples_.push({.depth_mm = contact_z_mm_ - readings.position_mm.z, .force_N = readings.force_N});
    if (!stored || static_cast<int>(samples_.size()) >= settings_.samples) {
      conclude(ProbeOutcome::too_few);
      return;
    }
  }
  const double next_z_mm = target_mm_.z - settings_.step_mm;
  if (!(start_mm_.z - next_z_mm <= settings_.travel_limit_mm)) {
    conclude(samples_.empty() ? ProbeOutcome::no_contact : ProbeOutcome::too_few);
    return;
  }
  target_mm_.z = next_z_mm;
  step_began_ = now;
}

void MaterialProbe::conclude(ProbeOutcome when_too_few) {
  const bool enough = samples_.size() >= 2;
  if (enough) stiffness_ = std::clamp(estimate(), 0.0, kRigid_N_per_mm);
  retreat(enough ? ProbeOutcome::measured : when_too_few);
}

void MaterialProbe::retreat(ProbeOutcome outcome) {
  outcome_ = outcome;
  target_mm_ = start_mm_;
  phase_ = ProbePhase::retreating;
}

double MaterialProbe::estimate() const {
  const auto count = static_cast<double>(samples_.size());
  if (settings_.estimate == ProbeEstimate::slope) {
    double mean_depth = 0.0;
    double mean_force = 0.0;
    for (const Sample& s : samples_) {
      mean_depth += s.depth_mm / count;
      mean_force += s.force_N / count;
    }
    double depth_depth = 0.0;
    double depth_force = 0.0;
    for (const Sample& s : samples_) {
      depth_depth += (s.depth_mm - mean_depth) * (s.depth_mm - mean_depth);
      depth_force += (s.depth_mm - mean_depth) * (s.force_N - mean_force);
    }
    return depth_depth > kLeastDepth_mm * kLeastDepth_mm ? depth_force / depth_depth : kRigid_N_per_mm;
  }
  double sum = 0.0;
  for (const Sample& s : samples_.view().subspan(1)) {
    sum += s.depth_mm > kLeastDepth_mm ? std::min(s.force_N / s.depth_mm, kRigid_N_per_mm) : kRigid_N_per_mm;
  }
  return settings_.estimate == ProbeEstimate::mean ? sum / (count - 1.0) : sum / count;
}

}  // namespace fyd::device
