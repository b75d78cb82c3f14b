// The pipeline's step and the simulated touchpad in virtual time, in one thread: faster than real time and
// reproducible. Tests, benchmarks and `fyd stiffness` use it; the station does the same with threads and a clock.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/pipeline/pipeline.h"
#include "core/sensing/finger_detector.h"
#include "core/sim/touchpad/simulated_camera.h"
#include "core/sim/touchpad/touchpad_world.h"

namespace fyd::sim {

struct LockstepOptions {
  pipeline::Parameters parameters;
  SimParameters sim;
  FingerPath finger = FingerPath::constant(0.0, 0.0, 6.0);
  /// true: pictures are drawn and the finger is detected in them; false: its true position with 0.1 mm of noise, much
  /// faster
  bool draw_pictures = true;
  /// Stiffness a robot reports from the start; NaN: no robot; the target is set by hand, or by a scene.
  double robot_stiffness_N_per_mm = 0.62;
  pipeline::LocalModel local;
};

class Lockstep {
 public:
  explicit Lockstep(const LockstepOptions& options);

  /// One millisecond. Commands and changes pushed into `next` before go in with it.
  const pipeline::Outputs& step();

  /// Steps for a time; `each` sees every step.
  void run(double seconds, const std::function<void(const pipeline::Outputs&)>& each = {});

  /// Inputs of the coming step, to which a test may add commands, changes and a robot's state; the touchpad's own are
  /// overwritten by `step`.
  pipeline::Inputs next;
  /// Called with the complete inputs just before each step; a test may falsify this step's copy.
  std::function<void(pipeline::Inputs&)> spoil;

  [[nodiscard]] TouchpadWorld& world() { return *world_; }
  [[nodiscard]] pipeline::Pipeline& pipeline() { return pipeline_; }
  [[nodiscard]] const pipeline::Outputs& outputs() const { return *outputs_; }
  [[nodiscard]] double time_s() const { return toSeconds(now_ - start_); }

 private:
  void takePicture();

  Instant start_;
  Instant now_;
  std::shared_ptr<TouchpadWorld> world_;
  SimulatedCamera camera_;
  sensing::FingerDetector detector_;
  pipeline::Pipeline pipeline_;
  bool draw_pictures_;
  double robot_stiffness_;
  Duration picture_period_;
  Duration picture_delay_;
  Instant next_picture_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  const pipeline::Outputs* outputs_ = nullptr;
};

}  // namespace fyd::sim
