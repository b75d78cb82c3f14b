// The steps of the calibration, one line each, in the recommended order. Each step is implemented in its own
// file, which defines the function named here; the page, the readiness list and the tests go through the list.
#include <iterator>

#include "app/console/calibrate/calibrate_step.h"

#define FYD_CALIBRATION_STEPS(STEPS)                                                                    \
  STEPS(encoderSteps)                                                                                   \
  STEPS(loadCellSteps)                                                                                  \
  STEPS(irSteps)                                                                                        \
  STEPS(noTouchSteps) /* with the new curves, and after the load cell, which begins with a zero of 0 */ \
  STEPS(cameraRegionSteps)                                                                              \
  STEPS(cameraScaleSteps)                                                                               \
  STEPS(clothSteps)                                                                                     \
  STEPS(stiffnessSteps)                                                                                 \
  STEPS(restSteps)                                                                                      \
  STEPS(textureSteps)

namespace fyd::console {

#define FYD_DECLARE(make) CalibrationSteps make(const station::Profile& profile);
FYD_CALIBRATION_STEPS(FYD_DECLARE)
#undef FYD_DECLARE

CalibrationSteps makeCalibrationSteps(const station::Profile& profile) {
  CalibrationSteps out;
#define FYD_APPEND(make) std::ranges::move(make(profile), std::back_inserter(out));
  FYD_CALIBRATION_STEPS(FYD_APPEND)
#undef FYD_APPEND
  return out;
}

}  // namespace fyd::console
