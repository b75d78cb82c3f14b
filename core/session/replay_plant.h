// What answers in a closed-loop replay: motors and cloth, as differences to what was recorded. With unchanged commands
// the inputs stay the recorded ones, bit for bit.
#pragma once

#include <array>

#include "core/control/fabric_identification.h"
#include "core/control/static_law.h"
#include "core/pipeline/inputs.h"
#include "core/pipeline/parameters.h"
#include "core/session/recording.h"
#include "core/sim/simulated_motor.h"

namespace fyd::session {

/// The cloth from the touches of a recording: stiffness against stretch, through the sensors' delay and lag.
/// @return an error that says what the recording lacks
[[nodiscard]] Result<control::IdentifiedFabric> identifyRecordedFabric(const Recording& recording,
                                                                       const control::ControlParameters& parameters);

class ReplayPlant {
 public:
  ReplayPlant(const control::IdentifiedFabric& fabric, const control::ControlParameters& parameters);

  /// Turns recorded inputs into those the new commands would have given. @param present of the step, tare included
  void answer(pipeline::Inputs& inputs, const pipeline::Parameters& present);
  /// Both commands of the same step, the recorded and the new.
  void follow(const control::MotorCommand& recorded, const control::MotorCommand& replayed, double elapsed_s);

 private:
  using Motors = std::array<sim::SimulatedMotor, control::kMotorCount>;
  [[nodiscard]] double forceFactor() const;

  control::StaticLaw law_;
  double shape_gain_;
  bool standing_ = false;  // the motors have not been set to the first encoder reading yet
  Motors recorded_{sim::SimulatedMotor(0.0), sim::SimulatedMotor(0.0)};
  Motors replayed_{sim::SimulatedMotor(0.0), sim::SimulatedMotor(0.0)};
  std::uint64_t bridge_seen_ = 0;
  double factor_ = 1.0;  // when the bridge's present reading came
};

}  // namespace fyd::session
