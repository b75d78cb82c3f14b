// The way to the finger from a measurement: breakaway of each motor, and the cloth's resonance under a finger.
//
// A sweep is one table at 1 kHz of several experiments, each with its own number `part`:
//   ramp    one motor's duty grows slowly from 0, the other's is 0; the first encoder count that changes for good tells
//           the breakaway. Both motors, both ways: what the cloth's tension adds one way it takes the other way.
//   chirp   both motors have the same duty, a sine whose frequency rises through 10…400 Hz in 8 s and more, with an
//           accelerometer on the cloth beside the finger (the robot's own will do), along the cloth's motion. At two
//           stretches or more, 10° apart.
// Encoders, load cell and currents cannot see the cloth: without an accelerometer its resonance is not determined.
//
// Chirp: the rollers' acceleration x follows from the duty by the motor model of FeltPlant (free speed, time constant,
// position gain and radius as given, breakaway as found, sliding friction the share of it that fits best). Then
//   Σ |Y(f) − g·e^(−2πi·f·d)·H(f; f₀, ζ)·X(f)|² over 10…400 Hz
// is least for resonance f₀, damping ζ, gain g and the sensor's delay d; every other 5 Hz is held out and tells the
// error.
//
// Offline: allocates.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/texture/felt_plant.h"

namespace fyd::texture {

struct SweepRow {
  double t_s = 0.0;
  int part = 0;
  double stretch_deg = 0.0;
  std::array<double, kFeltMotors> duty_percent{};
  std::array<int, kFeltMotors> encoder_counts{};  ///< 0…4095
  double acceleration_g = 0.0;                    ///< NaN where no accelerometer was read
};

/// CSV with columns t_s, part, stretch_deg, duty1_percent, duty2_percent, encoder1_counts, encoder2_counts,
/// acceleration_g; an empty field is allowed in the last.
[[nodiscard]] Result<std::vector<SweepRow>> parseSweep(std::string_view text, std::string_view source_name);

struct FoundBreakaway {
  double percent = 0.0;  ///< mean of both ways
  double sigma_percent = 0.0;
  double asymmetry_percent = 0.0;  ///< half of what one way differs from the other
};

struct FoundCloth {
  int part = 0;
  double stretch_deg = 0.0;
  double resonance_Hz = 0.0;
  double sigma_Hz = 0.0;
  double damping = 0.0;
  double sigma_damping = 0.0;
  double gain = 0.0;
  double delay_ms = 0.0;
  double held_out_error = 0.0;  ///< of the acceleration, RMS over RMS
};

struct FeltIdentification {
  FeltPlant plant;  ///< identified
  std::array<FoundBreakaway, kFeltMotors> breakaway;
  std::vector<FoundCloth> cloths;
  double sliding_share = 0.0;   ///< friction of a turning motor over its breakaway
  double held_out_error = 0.0;  ///< the worst of the chirps
  double sigma_resonance_Hz = 0.0;
  std::string_view verdict;  ///< "good" or "usable"
};

/// @param base  what the sweep does not tell: free speed, time constant, position gain, radius
/// @return an error that names the part, what was found and what was expected, where something is not determined
[[nodiscard]] Result<FeltIdentification> identifyPlant(const std::vector<SweepRow>& sweep, const FeltPlant& base);

}  // namespace fyd::texture
