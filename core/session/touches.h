// Touches of a recording: when the finger pressed, and what each came to.
#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/session/progress.h"
#include "core/session/recording.h"

namespace fyd::session {

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
  /// RMS of the finger's acceleration by the vibration over what a finger feels; NaN: not recorded. @see felt_plant.h
  double felt_level_dB = pipeline::kNone;
};

/// In order; a break in contact shorter than 100 ms belongs to the touch.
/// @return the reader's error, and one when `progress` ended it
[[nodiscard]] Result<std::vector<Touch>> findTouches(const Recording& recording, const Progress& progress = {});

}  // namespace fyd::session
