// What must hold at each step, whatever happens. Written from the manual's page of safety, not from the step's code.
#pragma once

#include "core/pipeline/pipeline.h"
#include "tests/soak/soak.h"

namespace fyd::soak {

class Checks {
 public:
  Checks(const pipeline::Parameters& parameters, Figures& figures) : parameters_(parameters), figures_(figures) {}

  /// After each step: numbers and limits, no motion outside rendering, who may leave which state.
  void look(const pipeline::Inputs& inputs, const pipeline::Outputs& outputs);

  [[nodiscard]] pipeline::SafetyState state() const { return state_; }
  /// Whether the operator's own target was asked for last, and not the robot's.
  [[nodiscard]] bool byHand() const { return by_hand_; }
  /// Since the state is no longer Active.
  [[nodiscard]] Duration quiet(Instant now) const { return now - last_active_; }

 private:
  void numbers(const pipeline::Outputs& outputs) const;
  void standstill(const pipeline::Inputs& inputs, const pipeline::Outputs& outputs) const;
  void transition(const pipeline::Inputs& inputs, const pipeline::Outputs& outputs);

  const pipeline::Parameters& parameters_;
  Figures& figures_;
  bool began_ = false;
  bool by_hand_ = false;
  Instant before_{};
  Instant last_active_{};
  pipeline::SafetyState state_ = pipeline::SafetyState::disconnected;
  control::MotorCommand motors_;
  Vec3 touch_mm_;
  double stretch_deg_ = 0.0;
};

/// A fault of a simulator after which a session cannot stay Active for long: until when it may.
struct Deadline {
  std::string name;
  Instant until{};
  Instant ends{};         ///< the fault
  bool alone = true;      ///< no other fault of the same simulator near it
  bool of_robot = false;  ///< over with the operator's own target, for which no robot is needed
};

}  // namespace fyd::soak
