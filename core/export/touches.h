// Touches of a recording: times of contact, and figures of each.
#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/recording/progress.h"
#include "core/recording/reader/recording.h"

namespace fyd::exports {

struct Touch {
  double start_s = 0.0;
  double end_s = 0.0;
  double peak_force_N = pipeline::kNone;
  double peak_indentation_mm = pipeline::kNone;
  double stiffness_N_per_mm =
      pipeline::kNone;  ///< median while observable, over the settled part; never settled: the second half
  double target_N_per_mm = pipeline::kNone;  ///< reachable target at the touch's end
  double settling_s = pipeline::kNone;       ///< until measured stays within 5 % of the target; NaN: never
  double vibration_rms_percent = pipeline::kNone;
  /// RMS of the vibration's acceleration at the finger over the perception threshold; NaN: not recorded.
  /// @see felt_plant.h
  double felt_level_dB = pipeline::kNone;
};

/// In order; a break in contact shorter than 100 ms belongs to the touch.
/// @return the reader's error, and one when `progress` ended it
[[nodiscard]] Result<std::vector<Touch>> findTouches(const recording::Recording& recording,
                                                     const recording::Progress& progress = {});

}  // namespace fyd::exports
