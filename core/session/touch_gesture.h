// A recorded touch as a gesture card.
#pragma once

#include "core/session/touches.h"
#include "core/sim/gesture_card.h"

namespace fyd::session {

/// "foam.h5, touch 3": what a card of it is called and where it says it is from.
/// @param number from 1
[[nodiscard]] std::string touchName(const std::string& recording_path, std::size_t number);

/// A row for each picture that showed the finger during the touch, at the picture's own time; what lies beyond the
/// cloth's usable area is taken to its edge. @param name and @param source as the card's
/// @return the reader's error, and one for a touch of fewer than two pictures
[[nodiscard]] Result<sim::GestureCard> gestureOf(const Recording& recording, const Touch& touch, std::string name,
                                                 std::string source);

}  // namespace fyd::session
