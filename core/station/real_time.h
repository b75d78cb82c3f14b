// Requests real-time scheduling for the calling thread; without permission the thread keeps its normal priority.
#pragma once

namespace fyd::station {

/// SCHED_FIFO priorities of the station's threads, the most urgent first.
enum class Urgency : int { haptic = 80, link = 75, device = 70, robot = 60 };

/// @return whether it was granted
bool askForRealTime(Urgency urgency);

/// Locks the process' memory against paging where RLIMIT_MEMLOCK is unlimited.
void lockMemory();

}  // namespace fyd::station
