// Identifies the plant from duty to finger (felt_plant.h) from a measured sweep: breakaway of each motor, and the
// cloth's resonance under a finger.
//
// Of a sweep (plant_sweep.h):
//   ramp    one motor's duty grows slowly from 0, the other's is 0; the first lasting change of the encoder count gives
//           the breakaway. Both motors in both directions: the cloth's tension raises it in one and lowers it in the
//           other, and the mean cancels that.
//   chirp   both motors have the same duty, a sine whose frequency rises through 10…400 Hz in 4 s or more, with an
//           accelerometer on the cloth beside the finger (the robot's own is suitable), along the cloth's motion,
//           either way round. At two stretches or more, 10° apart. Fit: chirp_fit.h.
// Encoders, load cell and currents do not sense the cloth's vibration: the resonance needs the accelerometer.
//
// Offline: allocates.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/message.h"
#include "core/texture/felt/chirp_fit.h"

namespace fyd::texture {

struct FoundBreakaway {
  double percent = 0.0;  ///< mean of both directions
  double sigma_percent = 0.0;
  double asymmetry_percent = 0.0;  ///< half the difference of the two directions
};

struct FeltIdentification {
  FeltPlant plant;  ///< with the identified constants
  std::array<FoundBreakaway, kFeltMotors> breakaway;
  std::vector<FoundCloth> cloths;
  double sliding_share = 0.0;   ///< sliding friction over breakaway
  double held_out_error = 0.0;  ///< largest of the chirps
  double sigma_resonance_Hz = 0.0;
  std::string_view verdict;  ///< "good" or "usable"
};

/// @param base constants that the sweep does not identify: free speed, time constant, position gain, radius
/// @return an error that names what was found and what was expected, where something is not determined, the gains of
/// two chirps differ by more than a factor of 2, or a constant is out of its parameter's range
[[nodiscard]] Result<FeltIdentification> identifyPlant(const std::vector<SweepRow>& sweep, const FeltPlant& base);

}  // namespace fyd::texture
