// The readiness list: what must hold before arming, in the operator's words.
#pragma once

#include <vector>

#include "core/base/message.h"
#include "core/pipeline/input_health.h"

namespace fyd::station {

/// One line of the list.
struct ReadinessLine {
  Message what;
  bool ok = false;
  Message why;     ///< what is wrong, as a phrase; empty when ok
  Message remedy;  ///< what the operator does about it, as a sentence; empty when ok
  pipeline::Fault fault = pipeline::Fault::none;
};

/// @param faults what is missing for Active
[[nodiscard]] std::vector<ReadinessLine> readinessOf(const pipeline::FaultSet& faults, bool has_robot);

}  // namespace fyd::station
