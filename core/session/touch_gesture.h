// A recorded touch as a gesture card.
#pragma once

#include "core/session/touches.h"
#include "core/sim/gesture_card.h"

namespace fyd::session {

/// A row for each picture that showed the finger during the touch, at the picture's own time; what lies beyond the
/// cloth's usable area is taken to its edge. @param name and @param source as the card's
/// @return the reader's error, and one for a touch of fewer than two pictures
[[nodiscard]] Result<sim::GestureCard> gestureOf(const Recording& recording, const Touch& touch, std::string name,
                                                 std::string source);

}  // namespace fyd::session
