#include "app/cli/interrupt.h"

#include <csignal>

namespace fyd::cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;

}  // namespace

void watchForInterrupt() {
  interrupted = 0;
  const auto remember = [](int) { interrupted = 1; };
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

bool wasInterrupted() { return interrupted != 0; }

}  // namespace fyd::cli
