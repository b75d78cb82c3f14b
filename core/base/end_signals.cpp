#include "core/base/end_signals.h"

#include <fcntl.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>

namespace fyd {
namespace {

// All that the signal handler accesses.
std::atomic<int> came = 0;
std::atomic<std::int64_t> came_at_ns = 0;
std::atomic<int> told = -1;  // the pipe's writing end
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free);

constexpr std::int64_t kSameWish_ns = 1'000'000'000;

int read_end = -1;

std::int64_t now_ns() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{1'000'000'000} * now.tv_sec + now.tv_nsec;
}

void remember(int signal) {
  const int problem = errno;
  if (came == 0) {
    came_at_ns = now_ns();
    came = signal;
    const char byte = 0;
    (void)!::write(told, &byte, 1);
  }
  errno = problem;
  if (signal == SIGHUP || now_ns() - came_at_ns < kSameWish_ns) return;
  ::signal(signal, SIG_DFL);
  ::raise(signal);  // delivered when this handler returns
}

bool isIgnored(int signal) {
  struct sigaction now {};
  return ::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

void watchForEnd() {
  if (std::array<int, 2> ends{}; read_end < 0 && ::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) == 0) {
    read_end = ends[0];
    told = ends[1];
  }
  came = 0;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (signal == SIGHUP && isIgnored(signal)) continue;
    struct sigaction action {};
    action.sa_handler = remember;
    action.sa_flags = SA_RESTART;
    ::sigaction(signal, &action, nullptr);
  }
}

int endSignal() { return came; }

int endSignalDescriptor() { return read_end; }

void makeFailedWritesErrors() {
  for (const int signal : {SIGPIPE, SIGXFSZ}) ::signal(signal, SIG_IGN);
  // open() gives the lowest number that is free. For reading only: what is printed there fails, as on a closed one.
  while (true) {
    const int lowest = ::open("/dev/null", O_RDONLY);
    if (lowest > STDERR_FILENO) ::close(lowest);
    if (lowest < 0 || lowest > STDERR_FILENO) break;
  }
}

}  // namespace fyd
