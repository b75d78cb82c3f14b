// Texts of IndentationReason.
#include "core/sensing/indentation.h"

#include "core/base/message.h"

namespace fyd::sensing {

std::string_view toString(IndentationReason reason) {
  switch (reason) {
    case IndentationReason::measured: return sentence("measured");
    case IndentationReason::untouched: return sentence("untouched");
    case IndentationReason::some_invalid: return sentence("measured without the invalid sensors");
    case IndentationReason::inconsistent: return sentence("sensors contradict each other");
    case IndentationReason::uncertain: return sentence("too uncertain");
    case IndentationReason::too_few_sensors: return sentence("too few valid sensors");
    case IndentationReason::ir_stale: return sentence("distance readings missing or too old");
    case IndentationReason::finger_stale: return sentence("no recent picture");
  }
  return sentence("unknown");
}

}  // namespace fyd::sensing
