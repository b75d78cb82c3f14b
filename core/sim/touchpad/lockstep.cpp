#include "core/sim/touchpad/lockstep.h"

#include <cmath>

namespace fyd::sim {
namespace {

constexpr double kTruePositionNoise_mm = 0.1;
const Instant kStart = instantAt(1000.0);

}  // namespace

Lockstep::Lockstep(const LockstepOptions& options)
    : start_(kStart),
      now_(kStart),
      world_(std::make_shared<TouchpadWorld>(options.sim, options.finger, kStart)),
      camera_(world_),
      detector_(options.parameters.sensing.finger),
      pipeline_(options.parameters, options.local),
      draw_pictures_(options.draw_pictures),
      robot_stiffness_(options.robot_stiffness_N_per_mm),
      picture_period_(fromSeconds(1.0 / options.sim.camera_rate_Hz)),
      picture_delay_(fromSeconds(options.sim.camera_delay_ms * 1e-3)),
      next_picture_(kStart),
      random_(static_cast<std::uint64_t>(options.sim.seed)) {
  if (std::isfinite(robot_stiffness_)) {
    next.robot.phase = pipeline::LinkPhase::running;
  } else if (!options.local.scene) {
    (void)next.commands.push(
        {.action = pipeline::OperatorAction::target_by_hand, .value = options.parameters.step.hand_target_N_per_mm});
  }
}

void Lockstep::takePicture() {
  if (now_ < next_picture_) return;
  next_picture_ += picture_period_;
  if (draw_pictures_) {
    const device::CameraFrame frame = camera_.frameAt(now_);
    next.finger.set(detector_.detect(device::viewOf(frame.picture)), frame.taken);
    return;
  }
  const WorldSnapshot truth = world_->truthAt(now_ - picture_delay_);
  sensing::FingerDetection seen;
  seen.contact = !truth.finger.lifted;
  const Spot spot = seenSpot(truth, world_->parameters());
  seen.area_mm2 = spot.area_mm2;
  seen.area_px = spot.area_mm2 / (kMmPerPx_u * kMmPerPx_v);
  seen.x_mm = spot.x_mm + kTruePositionNoise_mm * normal_(random_);
  seen.y_mm = spot.y_mm + kTruePositionNoise_mm * normal_(random_);
  seen.quality = 1.0;
  seen.reason = seen.contact ? sensing::FingerReason::found : sensing::FingerReason::no_finger;
  next.finger.set(seen, now_);
}

const pipeline::Outputs& Lockstep::step() {
  now_ += TouchpadWorld::kStep;
  world_->advanceTo(now_);
  const device::TouchpadReadings readings = world_->readings();
  next.now = now_;
  next.ir = readings.ir;
  next.bridge = readings.bridge;
  next.motors = readings.motors;
  takePicture();
  if (std::isfinite(robot_stiffness_)) next.robot.state.set({.stiffness_N_per_mm = robot_stiffness_}, now_);
  pipeline::Inputs inputs = next;
  if (spoil) spoil(inputs);
  outputs_ = &pipeline_.step(inputs);
  world_->command(outputs_->motors);
  next.commands.clear();
  next.changes.clear();
  next.robot.commands.clear();
  next.robot.accelerations.clear();
  return *outputs_;
}

void Lockstep::run(double seconds, const std::function<void(const pipeline::Outputs&)>& each) {
  for (auto left = std::llround(seconds * 1e3); left > 0; --left) {
    const pipeline::Outputs& outputs = step();
    if (each) each(outputs);
  }
}

}  // namespace fyd::sim
