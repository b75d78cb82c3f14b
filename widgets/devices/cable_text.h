// What to do about a device that is silent, with the cable that it really hangs on.
#pragma once

#include <QString>

#include "core/device/device_report.h"
#include "core/pipeline/safety.h"
#include "core/station/profile/profile.h"

namespace fyd::widgets {

/// "Check the touchpad's power and its network cable to 10.0.0.7:502.". Empty where no cable is to blame.
[[nodiscard]] QString cableRemedy(pipeline::Fault fault, const station::SourceParameters& words);

/// The same where the device is there and another program has it: what is so, and what to do.
struct InUseText {
  QString why;     ///< "Another program drives the touchpad"
  QString remedy;  ///< "Close what drives it at 10.0.0.7:502, such as another console; …"
};
[[nodiscard]] InUseText inUseText(pipeline::Fault fault, const station::SourceParameters& words);
/// The part whose silence is this fault, among the touchpad and its motor board.
[[nodiscard]] device::Part silentPart(pipeline::Fault fault, const station::SourceParameters& words);

}  // namespace fyd::widgets
