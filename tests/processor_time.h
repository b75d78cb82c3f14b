// The time that a calculation took of the processor: unlike the clock's, no other program of the machine adds to it.
#pragma once

#include <time.h>

namespace fyd {

/// Of the calling thread.
inline double processorTime_s() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace fyd
