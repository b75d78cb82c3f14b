#include "core/sim/touchpad/simulated_camera.h"

namespace fyd::sim {
namespace {

constexpr std::uint64_t kCameraStream = 0x63616d657261ULL;  // keeps the camera's random numbers apart from the sensors'

}  // namespace

SimulatedCamera::SimulatedCamera(std::shared_ptr<TouchpadWorld> world, bool clock_waits)
    : world_(std::move(world)),
      renderer_(world_->parameters()),
      period_(fromSeconds(1.0 / world_->parameters().camera_rate_Hz)),
      delay_(fromSeconds(world_->parameters().camera_delay_ms / 1000.0)),
      random_(static_cast<std::uint64_t>(world_->parameters().seed) ^ kCameraStream),
      hold_(clock_waits) {}

Message SimulatedCamera::description() const {
  return say("simulated camera, 320 × 240 at {:.0f} fps", world_->parameters().camera_rate_Hz);
}

Result<device::CameraFrame> SimulatedCamera::next() {
  const Instant asked = Clock::now();
  due_ += period_;
  if (due_ < asked) due_ = asked;  // the first picture, or some were missed
  hold_.until(due_ + period_);
  Clock::sleepUntil(due_);
  const Instant taken = Clock::now();
  world_->advanceTo(taken);
  return frameAt(taken);
}

device::CameraFrame SimulatedCamera::frameAt(Instant when) {
  device::CameraFrame frame{.picture = {}, .taken = when, .number = ++number_};
  renderer_.render(world_->truthAt(when - delay_), random_, frame.picture);
  return frame;
}

}  // namespace fyd::sim
