#include "core/sensing/finger_types.h"

#include "core/base/message.h"

namespace fyd::sensing {

std::string_view toString(FingerReason reason) {
  switch (reason) {
    case FingerReason::found: return sentence("found");
    case FingerReason::no_finger: return sentence("no finger");
    case FingerReason::too_small: return sentence("too small");
    case FingerReason::at_edge: return sentence("at edge");
    case FingerReason::several: return sentence("several");
    case FingerReason::flat_picture: return sentence("flat picture");
    case FingerReason::black_picture: return sentence("black picture");
    case FingerReason::saturated: return sentence("saturated");
    case FingerReason::blurred: return sentence("blurred");
    case FingerReason::no_picture: return sentence("no picture");
    case FingerReason::light_unknown: return sentence("light unknown");
  }
  return sentence("unknown");
}

}  // namespace fyd::sensing
