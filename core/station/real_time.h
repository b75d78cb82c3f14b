// Asks the system for a real-time place for the calling thread; without the right to one the thread runs as it is.
#pragma once

namespace fyd::station {

/// Places of the station's threads, the most urgent first (SCHED_FIFO priorities).
enum class Urgency : int { haptic = 80, link = 75, device = 70, robot = 60 };

/// @return whether it was granted
bool askForRealTime(Urgency urgency);

/// Keeps what the process has in memory from being paged out, where the allowance for that is unlimited.
void lockMemory();

}  // namespace fyd::station
