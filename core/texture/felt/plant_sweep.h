// Measurements for the identification of the plant from duty to finger: one table at 1 kHz of several experiments, each
// with its own number `part`.
//
//   ramp    one motor's duty grows slowly from 0, the other's is 0
//   chirp   both motors have the same duty, a sine whose frequency rises
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/texture/felt/felt_plant.h"

namespace fyd::texture {

inline constexpr double kSweepRate_Hz = 1000.0;
inline constexpr int kSweepCountsPerTurn = 4096;

struct SweepRow {
  double t_s = 0.0;
  int part = 0;
  double stretch_deg = 0.0;
  std::array<double, kFeltMotors> duty_percent{};
  std::array<int, kFeltMotors> encoder_counts{};  ///< 0…4095
  double acceleration_g = 0.0;                    ///< NaN where no accelerometer was read
};

using SweepPart = std::vector<SweepRow>;  ///< the rows of one experiment, never empty

/// CSV with columns t_s, part, stretch_deg, duty1_percent, duty2_percent, encoder1_counts, encoder2_counts,
/// acceleration_g; an empty field is allowed in the last.
[[nodiscard]] Result<std::vector<SweepRow>> parseSweep(std::string_view text, std::string_view source_name);

/// Splits the table where `part` changes.
[[nodiscard]] std::vector<SweepPart> partsOf(const std::vector<SweepRow>& sweep);

}  // namespace fyd::texture
