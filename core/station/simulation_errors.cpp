#include "core/station/simulation_errors.h"

#include <cmath>

#include "core/sim/touchpad/picture.h"
#include "core/sim/touchpad/touchpad_world.h"

namespace fyd::station {

void SimulationErrors::ErrorSum::add(double squared) {
  squares += squared;
  ++count;
}

double SimulationErrors::ErrorSum::rms() const {
  return count == 0 ? pipeline::kNone : std::sqrt(squares / static_cast<double>(count));
}

SimulationErrors::SimulationErrors(std::shared_ptr<sim::TouchpadWorld> world, bool simulated_camera)
    : world_(std::move(world)), simulated_camera_(simulated_camera) {}

void SimulationErrors::addPicture(const CameraView& view) {
  if (!world_ || !simulated_camera_ || !view.finger.contact) return;
  const sim::WorldSnapshot truth = world_->truthAt(view.taken);
  if (truth.finger.lifted) return;
  const sim::Spot spot = sim::seenSpot(truth, world_->parameters());
  const double dx = view.finger.x_mm - spot.x_mm;
  const double dy = view.finger.y_mm - spot.y_mm;
  const std::lock_guard lock(mutex_);
  finger_.add(dx * dx + dy * dy);
}

void SimulationErrors::addSample(const pipeline::TelemetrySample& sample) {
  if (!world_ || !sample.contact) return;
  const sim::WorldSnapshot truth = world_->truthAt(sample.now);
  if (truth.finger.lifted) return;
  const double error = sample.indentation_mm - truth.finger.indentation_mm;
  const std::lock_guard lock(mutex_);
  if (std::isfinite(error)) indentation_.add(error * error);
  if (sample.state == pipeline::SafetyState::active) felt_g_.add(truth.felt_g * truth.felt_g);
}

SimulationTruth SimulationErrors::truth() const {
  const std::lock_guard lock(mutex_);
  return {.available = world_ != nullptr,
          .finger_error_mm_rms = finger_.rms(),
          .indentation_error_mm_rms = indentation_.rms(),
          .felt_g_rms = felt_g_.rms()};
}

}  // namespace fyd::station
