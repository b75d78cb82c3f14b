// A recorded touch as a gesture card.
#pragma once

#include "core/export/touches.h"
#include "core/sim/gesture_card.h"

namespace fyd::exports {

/// "foam.h5, touch 3": name and source of a touch's card; of the file's name what a card can hold.
/// @param number from 1
[[nodiscard]] std::string touchName(const std::string& recording_path, std::size_t number);

/// A row for each picture that showed the finger during the touch, at the picture's own time; positions beyond the
/// cloth's usable area are moved to its edge. @param name @param source of the card
/// @return the reader's error, and one for a touch of fewer than two pictures
[[nodiscard]] Result<sim::GestureCard> gestureOf(const recording::Recording& recording, const Touch& touch,
                                                 std::string name, std::string source);

}  // namespace fyd::exports
