// The pure step: all haptic behaviour in one function without I/O, threads or clock.
//
//   sensing   counts, bridge, finger            → force, indentation, stiffness
//   safety    ages, validity, operator, robot   → state
//   motion    finger, indentation               → touch message
//   scene     touch                             → simulated robot state (with a scene only)
//   coupling  robot state, finger               → target
//   control   target, measured stiffness        → stretch
//   texture   accelerations, surface or scene   → vibration duty
//
// Live operation, the headless runner, tests and replay call the same step; the same parameters, local model and inputs
// give the same outputs bit for bit. After construction a step neither allocates nor throws, and whatever comes in,
// no output is NaN where a number is promised and no command lies beyond its limits.
// Stability: stable since 0.1
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/api.h"
#include "core/base/error.h"
#include "core/control/motor_mixing.h"
#include "core/control/stiffness_controller.h"
#include "core/pipeline/input_health.h"
#include "core/pipeline/inputs.h"
#include "core/pipeline/local_model.h"
#include "core/pipeline/outputs.h"
#include "core/pipeline/parameters.h"
#include "core/pipeline/touch_motion.h"
#include "core/sensing/indentation.h"
#include "core/sensing/load_cell.h"
#include "core/sensing/stiffness_estimator.h"
#include "core/sensing/tare.h"
#include "core/teleop/coupling/touchpad_coupling.h"
#include "core/texture/felt/finger_prediction.h"
#include "core/texture/finger_speed.h"
#include "core/texture/texture_renderer.h"
#include "core/texture/virtual_texture.h"

namespace fyd::pipeline {

class FYD_API Pipeline {
 public:
  /// @param parameters each within its range, as those are that were read or set through checkParameter
  explicit Pipeline(const Parameters& parameters, const LocalModel& local = {});
  ~Pipeline();
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

  /// To be called nominally every millisecond. Time that does not advance moves nothing; time that goes back is
  /// reported as well.
  /// The result is valid until the next call.
  [[nodiscard]] const Outputs& step(const Inputs& inputs);

  /// As they are now, live changes and tare included.
  [[nodiscard]] const Parameters& parameters() const { return parameters_; }

  /// All that the next steps depend on, live parameters, tare and safety state included, as bytes (15 to 45 kB) that
  /// `restoreState` of this program and of later ones reads. Allocates.
  [[nodiscard]] std::string saveState() const;
  /// Continues from the saved step: the same inputs then give the same outputs bit for bit. This pipeline must have
  /// been made with the same local model and the same parameters, live ones apart.
  /// For replay. A pipeline that drives motors is never restored: the saved state may be Active, and only an operator
  /// arms.
  /// @return an error, and this pipeline as it was, for bytes that are damaged, cut short, too long, hold a parameter
  ///         or a module (or a version of one) that this program does not know, or were saved with other parameters
  ///         or another local model
  [[nodiscard]] Result<void> restoreState(std::string_view state);

  /// For replay: accepts live values outside the present range, as the recording program accepted them.
  void takeRecordedValues() { ranges_ = Ranges::mark; }

  /// The scene as it is now; null without one.
  [[nodiscard]] const scene::FeltScene* scene() const { return scene_.get(); }

  /// Id of the parameter that a key of the robot's operator sets; empty: none.
  [[nodiscard]] static std::string_view parameterOf(RobotCommand command);
  /// The one that OperatorAction::target_by_hand sets.
  static constexpr std::string_view kHandTarget = "pipeline.hand_target_N_per_mm";

 private:
  void takeTime(const Inputs& inputs);
  void applyChanges(const Inputs& inputs);
  void applyRobotCommands(const Inputs& inputs);
  void sense(const Inputs& inputs);
  void stepTare(const Inputs& inputs);
  void judge(const Inputs& inputs);
  void stepSafety(const Inputs& inputs);
  void stepMotion(const Inputs& inputs);
  void stepScene(const Inputs& inputs);
  void stepCoupling(const Inputs& inputs);
  void stepControl(const Inputs& inputs);
  void stepTexture(const Inputs& inputs);
  void writeTelemetry(const Inputs& inputs);

  /// @return whether it was taken; reported either way
  bool changeParameter(std::uint16_t index, double value);
  template <class Value>
  bool setParameter(std::string_view id, Value&& value);
  void followRobotReference(const RobotMotorReference& reference);
  /// `to_deg`, or as near to it as the commanded rate allows in this step.
  [[nodiscard]] double approach(double from_deg, double to_deg) const;
  void configure();
  [[nodiscard]] double target() const;
  [[nodiscard]] double placeFactor() const;
  /// The robot's state: simulated by the scene if there is one, otherwise received from the robot.
  [[nodiscard]] const Timed<RobotState>& told(const Inputs& inputs) const;
  [[nodiscard]] bool rendering(const Inputs& inputs) const;
  [[nodiscard]] std::optional<Fault> newFault(const Inputs& inputs) const;
  void report(const Event& event) { (void)outputs_.events.push(event); }

  // The state.
  struct Between;
  template <class Visit>
  void eachModule(Visit&& visit);
  [[nodiscard]] std::string saveModules();
  void restoreModules(std::istream& bytes);

  Parameters parameters_;
  std::vector<Parameter> bound_;  // into parameters_
  Ranges ranges_ = Ranges::bind;

  sensing::IndentationEstimator indentation_;
  sensing::LoadCell load_cell_;
  sensing::StiffnessEstimator stiffness_;
  sensing::Tare tare_;
  teleop::TouchpadCoupling coupling_;
  control::StiffnessController controller_;
  control::MotorMixing mixing_;
  texture::TextureRenderer renderer_;
  std::optional<texture::VirtualTexture> surface_;
  std::unique_ptr<scene::FeltScene> scene_;
  texture::FingerSpeed finger_speed_;
  texture::FingerPrediction finger_prediction_;
  InputHealth health_;
  Safety safety_;
  TouchMotion motion_;

  // between steps
  bool started_ = false;
  Instant last_now_{};
  std::uint64_t steps_ = 0;
  std::uint64_t missed_at_second_start_ = 0;
  Instant second_start_{};
  std::uint64_t last_finger_ = 0;
  std::uint64_t last_bridge_ = 0;
  LinkPhase last_phase_ = LinkPhase::none;
  bool target_by_hand_ = false;
  bool target_was_clamped_ = false;
  bool robot_sets_reference_ = false;
  double stretch_deg_ = 0.0;  // last reference
  double translation_deg_ = 0.0;
  Vec3 newest_acceleration_g_;
  Timed<RobotState> of_scene_;

  // of this step
  Duration elapsed_{};
  Timed<double> force_N_;
  sensing::IndentationEstimate indent_;
  sensing::Contact contact_;
  sensing::StiffnessEstimate stiff_;
  control::RollerAngles rollers_;
  teleop::TouchpadCouplingOutput coupled_;
  control::ControlOutput control_;
  texture::TextureOutput texture_;
  FaultSet faults_;
  FaultSet interruptions_;
  Outputs outputs_;
};

}  // namespace fyd::pipeline
