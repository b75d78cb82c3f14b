#include "core/sensing/force_fusion.h"

#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"

namespace fyd::sensing {
namespace {

constexpr double kStart_mm_per_N = 1.8;
constexpr double kStartSigma_mm_per_N = 0.6;
constexpr double kStillPace = 0.05;    // mm/N/√s while the motors stand
constexpr double kMovingPace = 0.5;    // … and while they stretch the cloth
constexpr double kStartStill = 0.9;    // probability that a touch begins with the motors standing
constexpr double kLeastForce_N = 0.2;  // below it a reading says nothing of the compliance
constexpr double kForceSigma_N = 0.03;
constexpr double kLargestFusedForce_N = 1000.0;  // beyond any finger: keeps the arithmetic finite
constexpr Duration kOldestForce = std::chrono::milliseconds(100);
constexpr double kContradiction = 4.0;  // standard deviations …
constexpr double kPersistent_s = 0.4;   // … for this long

}  // namespace

ForceFusion::ForceFusion() {
  compliance_.configure(kStillPace, kMovingPace, kStart_mm_per_N, kStartSigma_mm_per_N, kStartStill);
  restart();
}

void ForceFusion::restart() {
  compliance_.restart();
  contradiction_s_ = 0.0;
  contradicted_ = false;
}

void ForceFusion::takeForce(const Timed<double>& force_N) {
  if (force_N.count == last_count_) return;
  last_count_ = force_N.count;
  known_ = force_N.count > 0 && std::abs(force_N.value) <= kLargestFusedForce_N;  // false for NaN
  if (!known_) return;
  forces_[written_ % forces_.size()] = {.value_N = force_N.value, .taken = force_N.taken};
  ++written_;
}

double ForceFusion::forceAt(Instant when) const {
  const std::size_t kept = std::min(written_, forces_.size());
  const Force* later = nullptr;
  for (std::size_t back = 1; back <= kept; ++back) {
    const Force& force = forces_[(written_ - back) % forces_.size()];
    if (force.taken > when) {
      later = &force;
      continue;
    }
    if (later == nullptr) return force.value_N;
    const double whole = toSeconds(later->taken - force.taken);
    const double share = whole > 0.0 ? toSeconds(when - force.taken) / whole : 0.0;
    return force.value_N + share * (later->value_N - force.value_N);
  }
  return later != nullptr ? later->value_N : 0.0;
}

void ForceFusion::update(double dt_s, Instant taken, std::span<const IndentationFilter::Measurement> measurements) {
  const double force = forceAt(taken);
  if (!known_ || force < kLeastForce_N) return;
  std::array<IndentationFilter::Measurement, 8> of_compliance;
  const std::size_t count = std::min(measurements.size(), of_compliance.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto& m = measurements[i];
    of_compliance[i] = {.z_mm = m.z_mm,
                        .h = m.h * force,
                        .sigma_mm = math::hypot(m.sigma_mm, m.h * compliance_.value_mm() * kForceSigma_N)};
  }
  compliance_.update(dt_s, std::span(of_compliance).first(count));
}

void ForceFusion::compare(double dt_s, double indentation, double sigma) {
  if (!known_) return;
  const double apart = std::abs(indentation - indentation_mm());
  const bool contradicts = apart > kContradiction * math::hypot(sigma, sigma_mm());
  contradiction_s_ = contradicts ? contradiction_s_ + std::max(0.0, dt_s) : 0.0;
  contradicted_ = contradicted_ || contradiction_s_ > kPersistent_s;
}

bool ForceFusion::usable(Instant now) const {
  if (!known_ || contradicted_ || written_ == 0) return false;
  const Duration age = now - forces_[(written_ - 1) % forces_.size()].taken;
  return age <= kOldestForce;
}

double ForceFusion::indentation_mm() const {
  if (written_ == 0) return 0.0;
  return std::max(0.0, compliance_.value_mm()) * forces_[(written_ - 1) % forces_.size()].value_N;
}

double ForceFusion::sigma_mm() const {
  if (written_ == 0) return compliance_.sigma_mm();
  return math::hypot(compliance_.sigma_mm() * forces_[(written_ - 1) % forces_.size()].value_N,
                     compliance_.value_mm() * kForceSigma_N);
}

}  // namespace fyd::sensing
