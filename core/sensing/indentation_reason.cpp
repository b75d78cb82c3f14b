#include "core/sensing/indentation.h"

namespace fyd::sensing {

std::string_view toString(IndentationReason reason) {
  switch (reason) {
    case IndentationReason::measured: return "measured";
    case IndentationReason::untouched: return "untouched";
    case IndentationReason::some_invalid: return "measured without the invalid sensors";
    case IndentationReason::inconsistent: return "sensors contradict each other";
    case IndentationReason::uncertain: return "too uncertain";
    case IndentationReason::too_few_sensors: return "too few valid sensors";
    case IndentationReason::ir_stale: return "distance readings missing or too old";
    case IndentationReason::finger_stale: return "no recent picture";
  }
  return "unknown";
}

}  // namespace fyd::sensing
