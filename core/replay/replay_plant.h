// The plant of a closed-loop replay: motors and cloth, as differences from the recording. With unchanged commands the
// inputs stay the recorded ones, bit for bit.
#pragma once

#include <array>

#include "core/control/cloth_identification.h"
#include "core/control/static_law.h"
#include "core/pipeline/inputs.h"
#include "core/pipeline/parameters.h"
#include "core/recording/reader/recording.h"
#include "core/sim/touchpad/simulated_motor.h"

namespace fyd::replay {

/// The cloth from the touches of a recording: stiffness against stretch, through the sensors' delay and lag.
/// @return an error that says what is missing in the recording
[[nodiscard]] Result<control::IdentifiedCloth> identifyRecordedCloth(const recording::Recording& recording,
                                                                     const control::ControlParameters& parameters);

class ReplayPlant {
 public:
  ReplayPlant(const control::IdentifiedCloth& cloth, const control::ControlParameters& parameters);

  /// Turns recorded inputs into those that the new commands would have given. @param present the step's parameters,
  /// tare included
  void answer(pipeline::Inputs& inputs, const pipeline::Parameters& present);
  /// Advances the simulated motors by both commands of the same step, the recorded and the new.
  void follow(const control::MotorCommand& recorded, const control::MotorCommand& replayed, double elapsed_s);

 private:
  using Motors = std::array<sim::SimulatedMotor, control::kMotorCount>;
  [[nodiscard]] double forceFactor() const;

  control::StaticLaw law_;
  double shape_gain_;
  bool standing_ = false;  // whether the motors have been set to the first encoder reading
  Motors recorded_{sim::SimulatedMotor(0.0), sim::SimulatedMotor(0.0)};
  Motors replayed_{sim::SimulatedMotor(0.0), sim::SimulatedMotor(0.0)};
  std::uint64_t bridge_seen_ = 0;
  double factor_ = 1.0;  // on the force, when the bridge's present reading came
};

}  // namespace fyd::replay
