// What to do about a device that is silent, with the cable that it really hangs on.
#pragma once

#include <QString>

#include "core/pipeline/safety.h"
#include "core/station/profile/profile.h"

namespace fyd::widgets {

/// "Check the touchpad's power and its network cable to 10.0.0.7:502.". Empty where no cable is to blame.
[[nodiscard]] QString cableRemedy(pipeline::Fault fault, const station::SourceParameters& words);

}  // namespace fyd::widgets
