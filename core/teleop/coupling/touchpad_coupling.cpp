#include "core/teleop/coupling/touchpad_coupling.h"

#include <algorithm>
#include <cmath>

#include "core/teleop/coupling/model_coupling.h"

namespace fyd::teleop {
namespace {

constexpr double kDeepest_mm = 100.0, kStrongest_N = 1000.0,
                 kStiffest_N_per_mm = 1000.0;  // bounds of a touchpad's readings
constexpr double kFurthest_mm = 1e3 * kFurthest_m;
constexpr double kReserve_mJ = 1e3 * PortEnergy::kReserve_J;
constexpr double kBeyond_mm = 1e3 * SurfaceEstimator::kBeyond_m;

double bounded(double stiffness) { return std::clamp(stiffness, kLeastTarget_N_per_mm, kMostTarget_N_per_mm); }

bool isPlace(const Vec3& p) {
  return std::abs(p.x) <= kFurthest_mm && std::abs(p.y) <= kFurthest_mm && std::abs(p.z) <= kFurthest_mm;
}

bool samePlace(const Vec3& a, const Vec3& b) {
  const double x = a.x - b.x, y = a.y - b.y;
  return x * x + y * y <= TouchpadCoupling::kOnePlace_mm * TouchpadCoupling::kOnePlace_mm;
}

}  // namespace

TouchEnergy::Step TouchEnergy::observe(bool touched, double indentation_mm, double force_N, double cloth_N_per_mm) {
  began_ = touched && !touched_;
  touched_ = touched;
  if (began_) {
    known_ = true;
    energy_mJ_ = given_mJ_ = depth_mm_ = cloth_ = 0.0;
  }
  if (touched && !(std::abs(indentation_mm) <= kDeepest_mm && std::abs(force_N) <= kStrongest_N)) return {};
  const double depth = touched ? std::max(0.0, indentation_mm) : 0.0;
  const double force = touched ? std::max(0.0, force_N) : 0.0;  // a cloth does not pull
  const Step step{.mean_mm = 0.5 * (depth + depth_mm_), .grew_mm = depth - depth_mm_};
  depth_mm_ = depth;
  const double held_mJ = 0.5 * force * depth;
  if (touched && cloth_N_per_mm > 0.0 && cloth_N_per_mm <= kStiffest_N_per_mm) {
    const double meanwhile_mJ = 0.5 * (held_mJ + energy_mJ_ + given_mJ_);
    if (cloth_ > 0.0) given_mJ_ += meanwhile_mJ * 2.0 * (cloth_N_per_mm - cloth_) / (cloth_N_per_mm + cloth_);
    cloth_ = cloth_N_per_mm;
  }
  energy_mJ_ = held_mJ - given_mJ_;
  return step;
}

void TouchpadCoupling::hear(const TouchpadCouplingInput& input) {
  if (input.robot_count == count_) return;
  count_ = input.robot_count;
  if (count_ == 0) {
    estimate_ = model_ = 0.0;
    met_ = gone_ = false;
    return;
  }
  const RobotTold& told = input.robot;
  if (!isPlace(told.position_mm) || !(told.stiffness_N_per_mm >= 0.0) || std::isinf(told.stiffness_N_per_mm)) return;
  if (told.stiffness_N_per_mm == 0.0) {
    gone_ = gone_ || (met_ && told.position_mm.z < met_place_mm_.z - kBeyond_mm);
    return;
  }
  estimate_ = bounded(told.stiffness_N_per_mm);
  told_place_mm_ = told.position_mm;
  gone_ = false;
  const bool higher = told.position_mm.z > met_place_mm_.z;
  if (!met_ || higher || !samePlace(told.position_mm, met_place_mm_)) met_place_mm_ = told.position_mm;
  met_ = true;
}

void TouchpadCoupling::follow(const TouchpadCouplingInput& input) {
  if (model_ <= 0.0 || !input.touched || !input.led) {
    model_ = estimate_;
    place_mm_ = told_place_mm_;
    return;
  }
  const double goal = surface();
  const bool softer = goal < model_, same = goal <= model_ * (1.0 + kSame);
  if (same) place_mm_ = told_place_mm_;
  if (!softer && (same || samePlace(told_place_mm_, place_mm_))) return;
  const double dt = input.elapsed_s > 0.0 ? std::min(input.elapsed_s, kLongestStep_s) : 0.0;  // NaN too
  model_ += (goal - model_) * dt / ModelHandEnd::kSofteningTime_s;
}

double TouchpadCoupling::reflected(const TouchpadCouplingInput& input) const {
  const bool divides = input.touched && input.indentation_mm >= input.least_indentation_mm;
  if (!divides || !std::isfinite(input.robot.force_N)) return surface();
  return bounded(std::max(0.0, input.robot.force_N) / input.indentation_mm);
}

TouchpadCouplingOutput TouchpadCoupling::step(const TouchpadCouplingInput& input) {
  hear(input);
  follow(input);
  const TouchEnergy::Step moved =
      energy_.observe(input.touched, input.indentation_mm, input.force_N, input.cloth_N_per_mm);
  if (energy_.began()) withheld_mJ_ = 0.0;

  TouchpadCouplingOutput out;
  double asked = surface(), given = asked;
  switch (input.choice) {
    case TouchpadCouplingChoice::direct: break;
    case TouchpadCouplingChoice::model: given = model_; break;
    case TouchpadCouplingChoice::spring:
    case TouchpadCouplingChoice::tdpa: asked = given = asked > 0.0 ? reflected(input) : 0.0; break;
  }
  if (input.choice == TouchpadCouplingChoice::tdpa && given > 0.0 && input.led && input.touched &&
      input.indentation_mm >= input.least_indentation_mm) {
    const double may_mJ = (1.0 + kTolerance) * std::max(0.0, energy_.energy_mJ()) + kReserve_mJ;
    given = bounded(std::min(given, 2.0 * may_mJ / (input.indentation_mm * input.indentation_mm)));
  }
  if (input.choice == TouchpadCouplingChoice::direct) {
    if (count_ > 0) out.target_N_per_mm = input.robot.stiffness_N_per_mm;
  } else if (given > 0.0) {
    out.target_N_per_mm = given;
  } else if (count_ > 0) {
    out.target_N_per_mm = 0.0;
  }
  if (asked > 0.0 && input.led) withheld_mJ_ += (given - asked) * moved.mean_mm * moved.grew_mm;
  if (energy_.known()) {
    out.finger_energy_mJ = energy_.energy_mJ();
    out.withheld_mJ = withheld_mJ_;
  }
  return out;
}

}  // namespace fyd::teleop
