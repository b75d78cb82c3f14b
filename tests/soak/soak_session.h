// One session of the soak: touchpad, camera, robot, operator and recorder for a while, faults of all of them at random.
#pragma once

#include "tests/soak/soak.h"

namespace fyd::soak {

/// @param number seeds it together with `chance`. @param folder for its files. `broken` ends it when something does not
/// hold
void runSession(std::uint64_t number, Chance& chance, const std::string& folder, Figures& figures);

/// Every fault that a session may begin, with a count of 0.
void nameFaults(Figures& figures);

}  // namespace fyd::soak
