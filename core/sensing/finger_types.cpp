#include "core/sensing/finger_types.h"

namespace fyd::sensing {

std::string_view toString(FingerReason reason) {
  switch (reason) {
    case FingerReason::found: return "found";
    case FingerReason::no_finger: return "no finger";
    case FingerReason::too_small: return "too small";
    case FingerReason::at_edge: return "at edge";
    case FingerReason::several: return "several";
    case FingerReason::flat_picture: return "flat picture";
    case FingerReason::black_picture: return "black picture";
    case FingerReason::saturated: return "saturated";
    case FingerReason::blurred: return "blurred";
    case FingerReason::no_picture: return "no picture";
  }
  return "unknown";
}

}  // namespace fyd::sensing
