// Measurements of a device test that identifies the dynamics from motor to finger: duties, encoders and accelerations,
// from the loop to the operator's thread, and there as rows of one millisecond.
//
// Accelerations come late and in batches; each row gets what was measured at its own time, along the axis that moved
// most in its experiment. A row that the loop missed repeats the one before, as the motors did.
#pragma once

#include <atomic>
#include <vector>

#include "core/base/ring.h"
#include "core/pipeline/inputs.h"
#include "core/texture/felt/plant_sweep.h"

namespace fyd::station {

class SweepTape {
 public:
  /// The loop's. Allocation-free; rows that the operator's thread does not fetch within 16 s are lost.
  /// @param experiment of the test, from 1; @param since_start of the test
  void add(const pipeline::Inputs& inputs, const control::MotorCommand& command, int experiment, Duration since_start,
           double stretch_deg);

  /// The operator's: forgets what was gathered.
  void restart();
  /// The operator's, several times a second while a test runs.
  void gather();
  /// The operator's: what was gathered since `restart`, experiments by their numbers. Accelerations end a little after
  /// the test; NaN where none was measured near.
  [[nodiscard]] std::vector<texture::SweepRow> rows() const;

 private:
  struct Moment {
    texture::SweepRow row;
    Instant at{};
  };
  static constexpr std::size_t kMoments = 16'384;

  Ring<Moment> moments_{kMoments};
  Ring<texture::AccelerationSample> samples_{2 * kMoments};

  // the operator's
  std::vector<Moment> gathered_;
  std::vector<texture::AccelerationSample> measured_;
};

}  // namespace fyd::station
