#include "core/station/real_time.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>

namespace fyd::station {

bool askForRealTime(Urgency urgency) {
  sched_param parameter{};
  parameter.sched_priority = static_cast<int>(urgency);
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter) == 0;
}

void lockMemory() {
  rlimit allowance{};
  // With a small allowance, locking would make later allocations of other threads fail.
  if (getrlimit(RLIMIT_MEMLOCK, &allowance) == 0 && allowance.rlim_cur == RLIM_INFINITY) mlockall(MCL_CURRENT);
}

}  // namespace fyd::station
