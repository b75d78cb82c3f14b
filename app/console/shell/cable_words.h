// What to do about a device that is silent, with the cable that it really hangs on.
#pragma once

#include <QString>

#include "app/console/shell/session.h"

namespace fyd::console {

/// "Check the touchpad's power and its network cable to 10.0.0.7:502.". Empty where no cable is to blame.
[[nodiscard]] QString cableRemedy(pipeline::Fault fault, const ConnectionWords& words);

}  // namespace fyd::console
